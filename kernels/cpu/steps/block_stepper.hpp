// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "kernels/cpu/contacts/lane_detector.hpp"
#include "kernels/cpu/islands/binary_pair.hpp"
#include "kernels/cpu/islands/flight_sums.hpp"
#include "kernels/cpu/steps/active_disks.hpp"
#include "kernels/cpu/steps/motion_bounds.hpp"
#include "kernels/physics/drives/drive_power.hpp"
#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Costs of the steps of a scheme, by which engines choose, [cycles a disk-step]. From times of
/// CD_n and CD_rot (0.76 to 0.78, Q = 1 and 50, rates 1e-4 and 1e-5).
struct StepCosts {
  Real by_itself;  ///< of a disk without contacts where all disks are stepped
  Real contact;    ///< and for each contact it has
  Real few_below;  ///< contacts per disk below which steps for few contacts cost less
};

/// Blocks that must be through the passes before, so that a pass may take a block.
enum class Awaits {
  own,         ///< the block itself; the pass finds its scratch as the pass before left it
  neighbours,  ///< those that its halo copies
  all          ///< all, whose reports the pass sees
};

/// Steps that a pass belongs to: sampled ones are those whose sums are taken.
enum class When { always, sampled, unsampled };

/// Data that a pass works on beside `now` and the records of `trial`. The engine makes room for all
/// that passes use.
struct Uses {
  enum : unsigned {
    near_pairs = 1,     ///< forces of all near pairs, not of those alone that touch
    contact_pairs = 2,  ///< the list of pairs that touch
    changes = 4,        ///< `trial` is zero where nothing acts, not another state
    trial_spins = 8,    ///< spins of `trial`, not in its records
    iterates = 16,      ///< BlockSystem::more_records
    separations = 32,   ///< BlockSystem::of_pairs, two numbers a pair
    drive = 64          ///< BlockSystem::disk_of, and powers of a one-body force
  };
};

/// Facts on a pass by which the engine orders it and makes room for it.
struct PassFacts {
  Awaits awaits = Awaits::own;
  When when = When::always;
  unsigned uses = 0;  ///< of Uses
};

/// Data of a step, as its passes see them.
struct StepAt {
  ShearedBox box, next_box;  ///< where the step begins and ends
  int pass = 0;              ///< place of the pass in the list
  BlockReport total = {};    ///< of all blocks, for a pass that awaits all
  /// Block that follows each one in this pass, [blocks]; null: they go by number.
  std::uint32_t const* next = nullptr;
  ActiveDisks const* active = nullptr;  ///< for few contacts
  BlockSums* sums = nullptr;            ///< [blocks], out; null: the step is not sampled
  DrivePower* drive_powers = nullptr;   ///< [blocks], out, where sums are, if there is a drive
};

/// Forces of the second of two stages in the scratch of a pass, [most_local]: in a sampled step
/// they stand behind those of both stages.
template <class Force>
Force* second_forces(BlockSystem const& s, StepAt const& at, Force* scratch) {
  return at.sums == nullptr ? scratch : scratch + s.blocks.most_local;
}

/// A pass of a step over all blocks. Law, repulsion and scheme are behind this interface: one
/// virtual call for a thousand disks, and engines are compiled once.
class BlockPass {
 public:
  explicit BlockPass(PassFacts const& what) : facts(what) {}
  virtual ~BlockPass() = default;

  PassFacts const facts;

  /// True if the pass belongs to a step whose sums are taken, or are not.
  bool belongs(bool sampled) const {
    return facts.when == When::always || (facts.when == When::sampled) == sampled;
  }

  /// Works on block b and returns its part of the block's report. scratch: of the calling thread,
  /// [blocks.most_local] of BlockStepper::scratch.
  virtual BlockReport run(BlockSystem const& system, std::uint32_t b, StepAt const& at,
                          void* scratch) const = 0;
};

using BlockPasses = std::vector<std::unique_ptr<BlockPass const>>;

/// Step of a scheme on a block of disks, by its form; StepperOf wraps it.
template <ContactLaw Law, class Repulsion, class Scheme>
struct BlockStep;

/// Steps of pairs of disks that meet no other disk; see BinaryCollisions.
class LonePairs {
 public:
  virtual ~LonePairs() = default;
  virtual BinaryOutcome collide(BinaryDisk* a, BinaryDisk* b, int count, std::int64_t steps,
                                Real strain_rate, FlightTimes const& flights,
                                SampleTimes const& times, BlockSums* sums,
                                LaneDetector* detector) const = 0;
};

/// Step of a scheme, under a law and a repulsion, as a list of passes.
class BlockStepper {
 public:
  BlockStepper(StepCosts const& of_passes, std::size_t of_disk)
      : costs(of_passes), scratch(of_disk) {}
  virtual ~BlockStepper() = default;

  StepCosts const costs;      ///< of passes for few and for many contacts
  std::size_t const scratch;  ///< of a pass, for each disk of a block, [bytes]

  /// Passes of a step. Only the last one changes what is visible outside.
  BlockPasses many;

  /// Passes of a step where few of the near pairs touch, with the same bits: contacts are found
  /// first and forces evaluated for them alone; all other disks are moved in one stream, x += v dt.
  /// Their report's speed is that of the disks that touch. Empty if disks without contacts do not
  /// fly straight, or the scheme has no such step.
  BlockPasses few;

  std::unique_ptr<LonePairs const> lone_pairs;  ///< null where `few` is empty

  /// True if a pass of `many` uses this. Those of `few` use the contact list beside.
  bool uses(unsigned what) const {
    return std::ranges::any_of(many, [=](auto const& pass) { return pass->facts.uses & what; });
  }

  /// Number of evaluations of all near pairs in a step.
  int evaluations() const {
    return static_cast<int>(std::ranges::count_if(
        many, [](auto const& pass) { return pass->facts.uses & Uses::near_pairs; }));
  }
};

}  // namespace bagnold
