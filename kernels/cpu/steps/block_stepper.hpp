// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/cpu/contacts/lane_detector.hpp"
#include "kernels/cpu/islands/binary_pair.hpp"
#include "kernels/cpu/islands/flight_sums.hpp"
#include "kernels/cpu/steps/active_disks.hpp"
#include "kernels/cpu/steps/motion_bounds.hpp"
#include "kernels/physics/drives/drive_power.hpp"
#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// What steps of a scheme cost, by which engines choose, [cycles a disk-step]; from times of CD_n
/// and CD_rot (0.76 to 0.78, Q = 1 and 50, rates 1e-4 and 1e-5).
struct StepCosts {
  Real by_itself;  ///< of a disk without contacts where all disks are stepped
  Real contact;    ///< and for each contact it has
  Real few_below;  ///< contacts per disk below which steps for few contacts cost less
};

/// What an engine must know of a law and a scheme to make room for its steps.
struct StepNeeds {
  bool rotates;             ///< the law: spins are there
  bool lists_contacts;      ///< steps with many contacts list them too
  bool trial_spins;         ///< `trial` holds spins, not in its records
  bool trial_is_change;     ///< `trial` is zero where nothing acts, not another state
  int evaluations;          ///< of all near pairs in a step
  int observed_forces;      ///< arrays of forces that measure() fills
  std::size_t force_bytes;  ///< of a disk's force
  StepCosts costs;
  /// Of the solution for the changes of the motions, if the scheme solves for them; then all disks
  /// are stepped, at all times.
  int terms = 0;
  bool driven = false;  ///< by a one-body force: disks that touch nothing do not fly straight
};

/// The step of a scheme on a block of disks, by its form; StepperOf shows it.
template <ContactLaw Law, class Repulsion, class Scheme>
struct BlockStep;

/// The step of a scheme, under a law and a repulsion, on one block of disks at a time. Which they
/// are is behind this face: one virtual call for a thousand disks, and engines are compiled once.
///
/// A step has two halves with a barrier between them, as `trial` of a block is read by its
/// neighbours. force: scratch of the calling thread, [system.blocks.most_local] of force_bytes.
class BlockStepper {
 public:
  explicit BlockStepper(StepNeeds const& what) : needs(what) {}
  virtual ~BlockStepper() = default;

  StepNeeds const needs;

  /// First half of a step: what the forces at t change, or the trial state at t + dt.
  virtual BlockReport predict(BlockSystem const& system, std::uint32_t b, ShearedBox const& box,
                              void* force) const = 0;

  /// Second half: the state at t + dt. observed: `force` is as measure() left it. seen: shown the
  /// new motion of each pack of disks, if there is one.
  virtual BlockReport correct(BlockSystem const& system, std::uint32_t b, ShearedBox const& box,
                              void* force, bool observed, FlightDeviation* seen) const = 0;

  /// Of a scheme with needs.terms, between the halves: iteration k of the system's solve, when
  /// all blocks have been through that before.
  virtual void iterate(BlockSystem const& system, std::uint32_t b, int k, void* force) const = 0;

  /// Both halves, bit for bit the same, where few of the near pairs touch: contacts are looked for
  /// first, forces worked out for them alone, and all other disks are moved in one stream, x += v
  /// dt. moved: scratch, [most_local]. The report's speed is that of the disks that touch.
  virtual BlockReport predict_few(BlockSystem const& system, ActiveDisks const& active,
                                  std::uint32_t b, ShearedBox const& box, void* force) const = 0;
  virtual BlockReport correct_few(BlockSystem const& system, ActiveDisks const& active,
                                  std::uint32_t b, ShearedBox const& box, void* force,
                                  bool observed, simd::Record* moved) const = 0;

  /// The sums of one block, when it and its neighbours have been through the first half of a step,
  /// and it has not been through the second. force: [observed_forces][most_local].
  virtual BlockSums measure(BlockSystem const& system, std::uint32_t b, Real strain_rate,
                            void* force) const = 0;

  /// Powers of the one-body force on a block, if there is one, after measure() with its force.
  virtual DrivePower drive_power(BlockSystem const& system, std::uint32_t b, Real strain_rate,
                                 void* force) const = 0;

  /// Brings `count` pairs of disks that meet no one else through steps; see BinaryCollisions.
  virtual BinaryOutcome collide(BinaryDisk* a, BinaryDisk* b, int count, std::int64_t steps,
                                Real strain_rate, FlightTimes const& flights,
                                SampleTimes const& times, BlockSums* sums,
                                LaneDetector* detector) const = 0;
};

}  // namespace bagnold
