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

/// Costs of the steps of a scheme, by which engines choose, [cycles a disk-step]. From times of
/// CD_n and CD_rot (0.76 to 0.78, Q = 1 and 50, rates 1e-4 and 1e-5).
struct StepCosts {
  Real by_itself;  ///< of a disk without contacts where all disks are stepped
  Real contact;    ///< and for each contact it has
  Real few_below;  ///< contacts per disk below which steps for few contacts cost less
};

/// Facts on a law and a scheme from which an engine allocates memory for its steps.
struct StepNeeds {
  bool rotates;             ///< the law: spins are there
  bool lists_contacts;      ///< steps with many contacts list them too
  bool trial_spins;         ///< `trial` holds spins, not in its records
  bool trial_is_change;     ///< `trial` is zero where nothing acts, not another state
  int evaluations;          ///< of all near pairs in a step
  int observed_forces;      ///< arrays of forces that measure() fills
  std::size_t force_bytes;  ///< of a disk's force
  StepCosts costs;
  /// Terms of the Chebyshev solution for the changes of the motions; 0 if the scheme solves for
  /// nothing. A scheme that solves always steps all disks.
  int terms = 0;
  bool driven = false;  ///< by a one-body force: disks that touch nothing do not fly straight
};

/// Step of a scheme on a block of disks, by its form; StepperOf wraps it.
template <ContactLaw Law, class Repulsion, class Scheme>
struct BlockStep;

/// Step of a scheme, under a law and a repulsion, on one block of disks at a time. Law, repulsion
/// and scheme are behind this interface: one virtual call for a thousand disks, and engines are
/// compiled once.
///
/// A step has two halves with a barrier between them, as `trial` of a block is read by its
/// neighbours. force: scratch of the calling thread, [system.blocks.most_local] of force_bytes.
class BlockStepper {
 public:
  explicit BlockStepper(StepNeeds const& what) : needs(what) {}
  virtual ~BlockStepper() = default;

  StepNeeds const needs;

  /// First half of a step: the changes by the forces at t, or the trial state at t + dt.
  virtual BlockReport predict(BlockSystem const& system, std::uint32_t b, ShearedBox const& box,
                              void* force) const = 0;

  /// Second half: the state at t + dt. observed: `force` is as measure() left it. seen: called with
  /// the new motion of each pack of disks, unless null.
  virtual BlockReport correct(BlockSystem const& system, std::uint32_t b, ShearedBox const& box,
                              void* force, bool observed, FlightDeviation* seen) const = 0;

  /// Iteration k of the system's solve, between the halves, for a scheme with needs.terms. All
  /// blocks must have done iteration k - 1.
  virtual void iterate(BlockSystem const& system, std::uint32_t b, int k, void* force) const = 0;

  /// Both halves for blocks in which few of the near pairs touch, with the same bits. Contacts are
  /// found first and forces evaluated for them alone; all other disks are moved in one stream, x +=
  /// v dt. moved: scratch, [most_local]. The report's speed is that of the disks that touch.
  virtual BlockReport predict_few(BlockSystem const& system, ActiveDisks const& active,
                                  std::uint32_t b, ShearedBox const& box, void* force) const = 0;
  virtual BlockReport correct_few(BlockSystem const& system, ActiveDisks const& active,
                                  std::uint32_t b, ShearedBox const& box, void* force,
                                  bool observed, simd::Record* moved) const = 0;

  /// Sums of one block, after it and its neighbours have been through the first half of a step, and
  /// before its second half. force: [observed_forces][most_local].
  virtual BlockSums measure(BlockSystem const& system, std::uint32_t b, Real strain_rate,
                            void* force) const = 0;

  /// Powers of the one-body force on a block, if there is one, after measure(), with the force that
  /// it left.
  virtual DrivePower drive_power(BlockSystem const& system, std::uint32_t b, Real strain_rate,
                                 void* force) const = 0;

  /// Steps `count` pairs of disks that meet no other disk; see BinaryCollisions.
  virtual BinaryOutcome collide(BinaryDisk* a, BinaryDisk* b, int count, std::int64_t steps,
                                Real strain_rate, FlightTimes const& flights,
                                SampleTimes const& times, BlockSums* sums,
                                LaneDetector* detector) const = 0;
};

}  // namespace bagnold
