// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/engine/blocks/block_lists.hpp"
#include "src/engine/contacts/contact_detector.hpp"
#include "src/engine/sampling.hpp"

namespace bagnold {

/// Way in which the block engine steps.
enum class Stepping { automatic, few_contacts, many_contacts, lookahead };

/// Steps of all disks, one after the other, with lists that are renewed before they become invalid.
///
/// Blocks are cut by place and not by thread, and each sums the forces on its own disks, so the
/// bits do not depend on threads.
class SingleSteps {
 public:
  struct Counters {
    std::int64_t steps = 0, few_contacts = 0, pairs_evaluated = 0, prunings = 0;
  };

  Counters counters;
  std::uint64_t touching = 0;  ///< pairs at the last step, those across edges twice
  bool few = false;            ///< steps for few contacts, until the next pruning

  SingleSteps(BlockDisks& disks, BlockLists& lists, ContactDetector& detector, Stepping stepping)
      : disks_(disks),
        lists_(lists),
        detector_(detector),
        stepping_(stepping),
        evaluations_(disks.stepper->evaluations()) {
    for (bool const sampled : {false, true}) {
      rounds_[false][sampled] = rounds_of(disks.stepper->many, sampled);
      rounds_[true][sampled] = rounds_of(disks.stepper->few, sampled);
    }
  }

  /// One step of all disks.
  void advance(Sampling const& sampling, OpenWindows& windows);

  /// Z, contacts across edges of blocks counted twice.
  Real contacts_per_disk() const {
    return 2 * static_cast<Real>(touching) / static_cast<Real>(disks_.count());
  }

  /// Cost of a step, [cycles a disk-step].
  Real cost(Real contacts) const {
    auto const& costs = disks_.stepper->costs;
    return costs.by_itself + costs.contact * contacts;
  }

  /// Prunes the inner list anew, and chooses between steps for few and for many contacts.
  void prune();

  /// Cuts the disks into blocks anew, at their present positions.
  void rebuild();

 private:
  /// Passes of a step that a block goes through one after the other, but for those that do not
  /// belong to it.
  struct Round {
    Awaits awaits;   ///< of the first one
    int begin, end;  ///< places in the step
  };
  using Rounds = std::vector<Round>;

  /// Order of the blocks: as a wavefront takes them in a half of the step, or by their numbers.
  struct Route {
    std::vector<std::uint32_t> const* order = nullptr;
    HalfOfStep half = first_half_of_step;
  };

  static Rounds rounds_of(BlockPasses const& passes, bool sampled);
  void keep_lists();
  void make_room();
  void go_through_both(Round const& first, Round const& second, StepAt const& at);
  void go_through(Round const& round, Route const& route, std::uint32_t begin, std::uint32_t end,
                  StepAt at);
  void count_step();
  ListUse use_of_inner() const;
  void make_room_for_drive();
  void add_up();

  BlockDisks& disks_;
  BlockLists& lists_;
  ContactDetector& detector_;
  Stepping stepping_;
  int evaluations_;      ///< of all near pairs in a step
  Rounds rounds_[2][2];  ///< [for few contacts][of a step that is sampled]
  ActiveDisks active_;
  std::int64_t arrangement_ = 0, listing_ = 0;  ///< of the system, that there is room for
  Blocks::Array<BlockReport> reports_;          ///< by block
  Blocks::Array<BlockSums> sums_;               ///< by block
  Blocks::Array<DrivePower> drive_powers_;      ///< by block, if there is a drive
  std::vector<Real> columns_;
};

}  // namespace bagnold
