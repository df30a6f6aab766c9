// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Facts on a law and a scheme from which an engine allocates memory and chooses its way.
struct StepNeeds {
  bool rotates;              ///< the law: spins are there
  bool lists_contacts;       ///< steps with many contacts list them too
  bool trial_spins;          ///< `trial` holds spins, not in its records
  bool trial_is_change;      ///< `trial` is zero where nothing acts, not another state
  int evaluations;           ///< of all near pairs in a step
  std::size_t scratch;       ///< of a pass, for each disk of a block, [bytes]
  StepCosts costs;           ///< of passes for few and for many contacts
  int more_records = 0;      ///< arrays in BlockSystem::more_records
  int numbers_per_pair = 0;  ///< in BlockSystem::of_pairs
  bool driven = false;       ///< by a one-body force: disks that touch nothing do not fly straight
};

/// Blocks that must be through the passes before, so that a pass may take a block.
enum class Awaits {
  own,         ///< the block itself; the pass finds its scratch as the pass before left it
  neighbours,  ///< those that its halo copies
  all          ///< all, whose reports the pass sees
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

/// A pass of a step over all blocks. Law, repulsion and scheme are behind this interface: one
/// virtual call for a thousand disks, and engines are compiled once.
class BlockPass {
 public:
  BlockPass(Awaits blocks, bool in_samples) : awaits(blocks), sampled(in_samples) {}
  virtual ~BlockPass() = default;

  Awaits const awaits;
  bool const sampled;  ///< belongs to steps whose sums are taken, and to no others

  /// Works on block b and returns its part of the block's report. scratch: of the calling thread,
  /// [blocks.most_local] of StepNeeds::scratch.
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
  explicit BlockStepper(StepNeeds const& what) : needs(what) {}
  virtual ~BlockStepper() = default;

  StepNeeds const needs;

  /// Passes of a step. Only the last one changes what is visible outside.
  BlockPasses many;

  /// Passes of a step where few of the near pairs touch, with the same bits: contacts are found
  /// first and forces evaluated for them alone; all other disks are moved in one stream, x += v dt.
  /// Their report's speed is that of the disks that touch. Empty if disks without contacts do not
  /// fly straight, or the scheme has no such step.
  BlockPasses few;

  std::unique_ptr<LonePairs const> lone_pairs;  ///< null where `few` is empty
};

}  // namespace bagnold
