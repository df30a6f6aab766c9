// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "kernels/device/dynamics/device_drive.hpp"
#include "kernels/device/dynamics/stepped_system.hpp"

namespace bagnold {

/// What a drive adds to the steps of a system on a device: launches of its own before and after
/// both stages of a step, and its powers.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
class StepDrive {
 public:
  static constexpr bool rotates = Law::rotates;
  using System = SteppedSystem<Law, Repulsion, Space, Scheme>;
  using Drive = DeviceDrive<rotates, Space>;
  using Motions = typename Drive::Motions;

  /// drive: null if there is none, and nothing else may be called then.
  explicit StepDrive(std::unique_ptr<Drive const> drive) : drive_(std::move(drive)) {}

  explicit operator bool() const { return drive_ != nullptr; }

  /// Comes after the first stage. strain_rate, step: of the step that begins.
  void begin(Space const& space, System const& system, Real strain_rate, std::int64_t step) {
    space_ = space;
    strain_rate_ = strain_rate;
    step_ = step;
    drive_->kick(space_, now(system), system.disks.trial_motion);
  }

  /// Forces whose sums a configuration has: the damping of what both first stages change.
  auto measured(System const& system, ChangeForces<Law, Repulsion, Space> const& forces) const {
    Motions const changes("observables::driven_changes", system.disks.motion.extent(0));
    drive_->kick_changes(space_, now(system), system.disks.trial_motion, changes);
    return DrivenChangeForces<Law, Repulsion, Space>{forces, changes};
  }

  /// Comes before the second stage. powers: whether they are asked for.
  void before_end(System const& system, bool powers) {
    auto const& disks = system.disks;
    power_ = {};
    before_ = {};
    if constexpr (TwoStageScheme<Scheme>) {
      if (powers) {
        before_ = Motions("observables::motion_before", disks.motion.extent(0));
        Kokkos::deep_copy(before_, disks.motion);
      }
      drive_->kick_changes(space_, now(system), disks.trial_motion, disks.motion);
    } else if (powers) {
      power_ = drive_->power(space_, now(system), disks.trial_motion, Motions{});
    }
  }

  /// Comes after the second stage. Returns true if disks were moved once more.
  bool after_end(System const& system) {
    auto const& disks = system.disks;
    if constexpr (TwoStageScheme<Scheme>) {
      if (before_.extent(0) != 0)  // trial_position: where the step began
        power_ = drive_->power(space_, seen(system, disks.trial_position, before_), disks.motion,
                               disks.trial_motion);
      return false;
    } else {
      drive_->kick_correction(space_, seen(system, disks.trial_position, disks.trial_motion),
                              disks.motion, disks.position);
      return true;
    }
  }

  /// Powers of the last step, if they were asked for.
  DrivePower const& power() const { return power_; }

 private:
  using Views = DrivenViews<rotates, Space>;

  template <class Positions, class SomeMotions>
  Views seen(System const& system, Positions const& position, SomeMotions const& motion) const {
    return {position, motion, system.disks.species, strain_rate_, step_};
  }

  /// The disks where the step begins.
  Views now(System const& system) const {
    return seen(system, system.disks.position, system.disks.motion);
  }

  std::unique_ptr<Drive const> drive_;
  Space space_{};
  Real strain_rate_ = 0;  ///< [1 / tau_e]
  std::int64_t step_ = 0;
  Motions before_;  ///< motion that powers of both stages start from; empty: not asked for
  DrivePower power_;
};

}  // namespace bagnold
