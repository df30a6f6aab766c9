// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/device/dynamics/device_drive.hpp"
#include "kernels/device/dynamics/scale_motion.hpp"
#include "kernels/device/dynamics/stepped_system.hpp"
#include "kernels/device/neighbors/verlet_list.hpp"
#include "kernels/device/sums/measure.hpp"
#include "src/engine/download_state.hpp"
#include "src/engine/drive_columns.hpp"
#include "src/engine/reference/row_contacts.hpp"
#include "src/engine/run_clock.hpp"
#include "src/engine/simulation.hpp"
#include "src/engine/throw_unsound.hpp"
#include "src/engine/wrap_state.hpp"

namespace bagnold {

/// A scheme plainly: a full neighbour list, every disk sums its own contacts. What the faster
/// engines are held against.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
class ReferenceEngine final : public Simulation {
 public:
  static constexpr bool rotates = Law::rotates;

  /// A start: `snapshot.list_position` empty means no list yet.
  ReferenceEngine(Law law, SpeciesTable table, StrainRates const& rates, double time_step,
                  double skin, Snapshot const& snapshot,
                  std::unique_ptr<DeviceDrive<rotates, Space> const> drive)
      : drive_(std::move(drive)),
        skin_(skin),
        clock_(rates, time_step, snapshot),
        step_(snapshot.step),
        builds_(snapshot.list_builds),
        diameter_(snapshot.state.diameter) {
    State const& state = snapshot.state;
    system_.table = table;
    system_.law = law;
    system_.time_step = time_step;
    auto& disks = system_.disks;
    disks.position = to_device<Space>("state::position", vectors(state.position));
    disks.motion = to_device<Space>("state::motion", motions<rotates>(state));
    disks.species = to_device<Space>("state::species", species_of(state.diameter));
    auto const count = state.count();
    disks.trial_position = Positions("dynamics::trial_position", count);
    disks.trial_motion = Motions("dynamics::trial_motion", count);
    disks.at_build = Positions("neighbors::at_build", count);
    disks.step.allocate(law, table, time_step, count);
    block_sums_ = Kokkos::View<Sums<rotates>*, Space>("observables::block_sums", blocks());
    if (snapshot.list_position.empty()) {
      renew_list();
    } else {
      list_ = clock_.at(snapshot.list_step).mark(snapshot.list_step);
      auto const at_build = vectors(snapshot.list_position);
      Kokkos::deep_copy(disks.at_build, view_of(at_build));
      build_list();
    }
  }

  int columns() const override { return engine_columns(rotates, drive_ != nullptr); }
  std::int64_t step() const override { return step_; }

  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    for (auto const end = std::min(step_ + steps, sampling.last_step); step_ < end;) {
      if (!system_.begin_step(loops_, box_at(step_))) stop_unsound();
      if (drive_) drive_->kick(loops_.space, driven(), system_.disks.trial_motion);
      auto const step = step_;
      bool const sampled = sampling.sampled(step);
      Sums<rotates> sums;
      if (sampled) sums = measure();
      if (windows.contacts)
        detect_along_rows(system_.forces(box_at(step)), step, sampling, windows);
      if (sampled && !drive_) windows.add(sampling.window(step), sums.value, 1);
      auto const power = do_step(sampled && drive_);
      if (sampled && drive_) add_driven(sums, power, sampling.window(step), windows);
      if (step_ == clock_.rate_end) change_rate();
    }
  }

  Snapshot snapshot() const override {
    Snapshot s;
    s.state = raw_state();
    s.list_position = pairs(to_host(system_.disks.at_build));
    s.list_step = list_.step;
    s.step = step_;
    s.initial_offset = clock_.initial_offset;
    s.initial_time = clock_.initial_time;
    s.list_builds = builds_;
    return s;
  }

  State state() const override { return wrap_state(raw_state()); }

 private:
  static constexpr bool trial_is_change = TwoStageScheme<Scheme>;
  using Positions = Kokkos::View<Vec2<Real>*, Space>;
  using Motions = Kokkos::View<Motion<rotates>*, Space>;

  std::int64_t blocks() const {
    return (system_.disks.count() + measured_block - 1) / measured_block;
  }

  ShearedBox box_at(std::int64_t step) const { return clock_.box(step, list_); }

  [[noreturn]] void stop_unsound() const {
    throw_unsound(loops_.space, system_.forces(box_at(step_)), clock_, step_, raw_state());
  }

  /// The disks as the drive sees them where the step begins.
  DrivenViews<rotates, Space> driven() const {
    auto const& disks = system_.disks;
    return {disks.position, disks.motion, disks.species, clock_.strain_rate, step_};
  }

  /// The drive's powers, if they are asked for.
  DrivePower do_step(bool powers) {
    double const strain = clock_.strain_since(list_, step_ + 1);
    double const next_strain = clock_.strain_since(list_, step_ + 2);
    DrivePower power;
    Motions before;
    if (drive_) before = drive_before_end(powers, power);
    Real largest2 = system_.end_step(loops_, box_at(step_), box_at(step_ + 1), strain, next_strain);
    if (drive_) drive_after_end(before, power, largest2, strain, next_strain);
    ++step_;
    if (largest2 == std::numeric_limits<Real>::max()) stop_unsound();
    double const widest = std::max(std::abs(strain), std::abs(next_strain));
    if (!list_holds(widest, largest2, skin_)) renew_list();
    return power;
  }

  /// The second stage, or where powers are asked for of a trial state these. What it returns is the
  /// motion that powers of both stages start from.
  Motions drive_before_end(bool powers, DrivePower& power) {
    auto& disks = system_.disks;
    auto const& space = loops_.space;
    Motions before;
    if constexpr (trial_is_change) {
      if (powers) {
        before = Motions("observables::motion_before", disks.motion.extent(0));
        Kokkos::deep_copy(before, disks.motion);
      }
      drive_->kick_changes(space, driven(), disks.trial_motion, disks.motion);
    } else if (powers) {
      power = drive_->power(space, driven(), disks.trial_motion, Motions{});
    }
    return before;
  }

  void drive_after_end(Motions const& before, DrivePower& power, Real& largest2, double strain,
                       double next_strain) {
    auto& disks = system_.disks;
    auto const& space = loops_.space;
    auto const seen = [&](auto const& position, auto const& motion) {
      return DrivenViews<rotates, Space>{position, motion, disks.species, clock_.strain_rate,
                                         step_};
    };
    if constexpr (trial_is_change) {
      if (before.extent(0) != 0)  // trial_position: where the step began
        power = drive_->power(space, seen(disks.trial_position, before), disks.motion,
                              disks.trial_motion);
    } else {
      drive_->kick_correction(space, seen(disks.trial_position, disks.trial_motion), disks.motion,
                              disks.position);
      largest2 = std::max(largest2, farthest2(strain, next_strain));
    }
  }

  /// The largest |w|^2 now and a step later, [d_s^2].
  Real farthest2(double strain, double next_strain) const {
    auto const& disks = system_.disks;
    Real largest2 = 0;
    loops_.reduce("dynamics::Farthest", disks.count(),
                  Farthest<rotates, Space>{disks.position, disks.motion, disks.at_build,
                                           system_.time_step, strain, next_strain},
                  Kokkos::Max<Real>(largest2));
    return largest2;
  }

  /// Goes on at the next strain rate; the list stays, if it still holds for a step.
  void change_rate() {
    double const factor = clock_.change_rate();
    loops_.for_all("dynamics::ScaleMotion", system_.disks.count(),
                   ScaleMotion<rotates, Space>{system_.disks.motion, factor});
    double const strain = clock_.strain_since(list_, step_);
    double const next_strain = clock_.strain_since(list_, step_ + 1);
    if (!list_holds(std::abs(next_strain), farthest2(strain, next_strain), skin_)) renew_list();
  }

  static void add_driven(Sums<rotates> const& sums, DrivePower const& power, std::int64_t window,
                         OpenWindows& windows) {
    std::vector<Real> columns(std::begin(sums.value), std::end(sums.value));
    append(columns, power);
    windows.add(window, columns, 1);
  }

  /// Take the disks into the box, build the list, and see that the next step stays within it.
  void renew_list() {
    list_ = clock_.mark(step_);
    system_.take_into_box(loops_, box_at(step_));
    build_list();
    ++builds_;

    double const strain = clock_.strain_since(list_, step_ + 1);
    auto const farthest = system_.farthest_of_next_step(loops_, strain);
    if (!list_holds(std::abs(strain), farthest.val, skin_))
      failure::too_fast(clock_, step_, static_cast<std::size_t>(farthest.loc),
                        std::sqrt(farthest.val), skin_);
  }

  /// The list of the disks at the last build.
  void build_list() {
    auto& disks = system_.disks;
    VerletList<Space> list{skin_, disks.at_build, std::move(disks.neighbors)};
    bagnold::build_list(loops_.space, list, disks.species, system_.table, clock_.box(list_));
    disks.neighbors = std::move(list.rows);
  }

  Sums<rotates> measure() {
    auto const forces = system_.measured_forces(box_at(step_));
    if constexpr (trial_is_change) {
      if (drive_)
        return sums_of(DrivenChangeForces<Law, Repulsion, Space>{forces, driven_changes()});
    }
    return sums_of(forces);
  }

  template <class Forces>
  Sums<rotates> sums_of(Forces const& forces) {
    loops_.for_all("observables::MeasureBlock", blocks(),
                   MeasureBlock<Forces, Space>{forces, block_sums_});
    Sums<rotates> total;
    for (auto const& block : to_host(block_sums_)) total += block;
    return total;
  }

  /// What the drive's second stage will change.
  Motions driven_changes() const {
    Motions const changes("observables::driven_changes", system_.disks.motion.extent(0));
    drive_->kick_changes(loops_.space, driven(), system_.disks.trial_motion, changes);
    return changes;
  }

  State raw_state() const {
    return download_state(system_.disks.position, system_.disks.motion, diameter_, clock_, step_);
  }

  Launches<Space> loops_{};
  SteppedSystem<Law, Repulsion, Space, Scheme> system_;
  std::unique_ptr<DeviceDrive<rotates, Space> const> drive_;  ///< null: none
  double skin_;                                               ///< [d_s]
  RunClock clock_;
  std::int64_t step_ = 0;
  ShearMark list_;  ///< of its build
  std::int64_t builds_ = 0;
  std::vector<double> diameter_;  ///< kept on the host: files have it, steps do not need it
  Kokkos::View<Sums<rotates>*, Space> block_sums_;
};

}  // namespace bagnold
