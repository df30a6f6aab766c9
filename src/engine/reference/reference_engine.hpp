// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/device/dynamics/follow_flow.hpp"
#include "kernels/device/dynamics/scale_box.hpp"
#include "kernels/device/dynamics/scale_motion.hpp"
#include "kernels/device/dynamics/stepped_system.hpp"
#include "kernels/device/launch_queue.hpp"
#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/device/sums/add_up.hpp"
#include "src/engine/download_state.hpp"
#include "src/engine/drive_columns.hpp"
#include "src/engine/reference/device_contacts.hpp"
#include "src/engine/reference/disk_order.hpp"
#include "src/engine/reference/step_drive.hpp"
#include "src/engine/run_clock.hpp"
#include "src/engine/simulation.hpp"
#include "src/engine/throw_unsound.hpp"
#include "src/engine/wrap_state.hpp"

namespace bagnold {

/// How ReferenceEngine goes about its launches. No bit depends on it.
struct LaunchPlan {
  std::int64_t queued = 1;  ///< steps that the host does not wait between
  bool sorts = false;       ///< disks lie in memory by where they are, see DiskOrder
};

/// A scheme plainly: a full neighbour list, every disk sums its own contacts. What the faster
/// engines are held against.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
class ReferenceEngine final : public Simulation {
 public:
  static constexpr bool rotates = Law::rotates;

  /// A start: `snapshot.list_position` empty means no list yet.
  ReferenceEngine(Law law, SpeciesTable table, StrainRates const& rates, double time_step,
                  double skin, Snapshot const& snapshot,
                  std::unique_ptr<DeviceDrive<rotates, Space> const> drive,
                  LaunchPlan const& plan = {})
      : drive_(std::move(drive)),
        skin_(skin),
        clock_(rates, time_step, snapshot),
        step_(snapshot.step),
        builds_(snapshot.list_builds),
        diameter_(snapshot.state.diameter),
        plan_(plan),
        order_(static_cast<std::int64_t>(snapshot.state.count()), plan.sorts),
        queue_(loops_.space, 2 * plan.queued),
        contacts_(static_cast<std::int64_t>(snapshot.state.count()), plan.queued) {
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
    if (order_.sorts()) other_species_ = Kokkos::View<Species*, Space>("state::other", count);
    disk_sums_ = SumsRow("observables::disk_sums", count);
    group_sums_ = SumsRow("observables::group_sums", groups_of_sums(disks.count()));
    totals_ = SumsRow("observables::totals", plan.queued);
    if (snapshot.list_position.empty()) {
      renew_list();
    } else {
      list_ = clock_.at(snapshot.list_step).mark(snapshot.list_step);
      auto const at_build = vectors(snapshot.list_position);
      Kokkos::deep_copy(disks.at_build, view_of(at_build));
      build_list();
    }
  }

  int columns() const override { return engine_columns(rotates, bool(drive_)); }
  std::int64_t step() const override { return step_; }

  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    bool const each_alone = plan_.queued == 1 || drive_ || !queueable;
    for (auto const end = std::min(step_ + steps, sampling.last_step); step_ < end;) {
      if (!each_alone) {
        do_queued(std::min({plan_.queued, end - step_, clock_.rate_end - step_}), sampling,
                  windows);
        if (step_ == clock_.rate_end) follow(clock_.change_rate());
        continue;
      }
      if (!system_.begin_step(loops_, box_at(step_))) stop_unsound();
      if (drive_) drive_.begin(loops_.space, system_, clock_.strain_rate, step_);
      auto const step = step_;
      bool const sampled = sampling.sampled(step);
      Sums<rotates> sums;
      if (sampled) sums = measure();
      if (windows.contacts) {
        contacts_.begin(step, windows);
        detect_contacts(loops_, step, sampling);
        contacts_.fetch(step + 1, sampling);
        contacts_.tell(sampling, windows);
      }
      if (sampled && !drive_) windows.add(sampling.window(step), sums.value, 1);
      do_step(sampled);
      if (sampled && drive_) add_driven(sums, sampling.window(step), windows);
      if (step_ == clock_.rate_end) follow(clock_.change_rate());
    }
    if (windows.contacts) contacts_.tell(sampling, windows);
  }

  void begin_piece(double strain_rate, double scale) override {
    if (scale != 1) {
      auto const& disks = system_.disks;
      loops_.for_all("dynamics::ScaleBox", disks.count(),
                     ScaleBox<rotates, Space>{disks.motion, disks.position, scale,
                                              clock_.strain_rate * (scale - 1)});
      clock_.scale_box(scale);
      renew_list();
    }
    if (strain_rate != clock_.strain_rate)
      follow(clock_.begin_piece(step_, strain_rate, list_.step));
  }

  double strain() const override { return clock_.strain(step_); }

  Snapshot snapshot() const override {
    Snapshot s = clock_.snapshot(step_, list_.step, builds_);
    s.state = raw_state();
    s.list_position = pairs(order_.in_first_order(to_host(system_.disks.at_build)));
    return s;
  }

  State state() const override { return wrap_state(raw_state()); }

 private:
  static constexpr bool trial_is_change = TwoStageScheme<Scheme>;
  /// Not where the host needs a number from the disks within a step.
  static constexpr bool queueable = TwoStageScheme<Scheme> || PredictCorrectScheme<Scheme>;
  using SumsRow = Kokkos::View<Sums<rotates>*, Space>;
  using Positions = Kokkos::View<Vec2<Real>*, Space>;
  using Motions = Kokkos::View<Motion<rotates>*, Space>;

  ShearedBox box_at(std::int64_t step) const { return clock_.box(step, list_); }

  [[noreturn]] void stop_unsound() const {
    throw_unsound(loops_.space, system_.forces(box_at(step_)), clock_, step_, raw_state(),
                  [this](std::size_t place) { return order_.original(place); });
  }

  /// So many steps, or fewer where the list is outrun, without waiting between them.
  void do_queued(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
    queue_.begin();
    if (windows.contacts) {
      steps = contacts_.steps(step_, steps, sampling, windows);
      contacts_.begin(step_, windows);
    }
    QueuedLoops<Space> const queued{&queue_};
    std::int64_t totals = 0;
    for (auto step = step_; step < step_ + steps; ++step) {
      double const strain = clock_.strain_since(list_, step + 1);
      double const next_strain = clock_.strain_since(list_, step + 2);
      queue_.set_limit({});
      system_.begin_step(queued, box_at(step));
      if (sampling.sampled(step)) add_up(queued, system_.measured_forces(box_at(step)), totals++);
      if (windows.contacts) detect_contacts(queued, step, sampling);
      queue_.set_limit(
          QueuedLimit::of_list(std::max(std::abs(strain), std::abs(next_strain)), skin_));
      system_.end_step(queued, box_at(step), box_at(step + 1), strain, next_strain);
    }
    if (windows.contacts) contacts_.tell(sampling, windows);  // of the queue before
    take_queued(steps, totals, sampling, windows);
  }

  template <class Loops>
  void detect_contacts(Loops const& loops, std::int64_t step, Sampling const& sampling) {
    contacts_.detect(loops, system_.forces(box_at(step)), order_.original(), step, sampling);
  }

  /// Reads how far the queue came, and stands there.
  void take_queued(std::int64_t steps, std::int64_t totals, Sampling const& sampling,
                   OpenWindows& windows) {
    auto const sums = totals == 0 ? std::vector<Sums<rotates>>{} : to_host(totals_);
    auto next_sums = sums.begin();
    bool stopped = false, sound = true;
    for (auto const& [value, limit] : queue_.results()) {
      stopped = !limit.allows(value);
      if (limit.by_list) {
        if (sampling.sampled(step_)) windows.add(sampling.window(step_), next_sums++->value, 1);
        ++step_;
        --steps;
      }
      if (!stopped) continue;
      sound = limit.by_list && value != std::numeric_limits<Real>::max();
      break;
    }
    if (windows.contacts) contacts_.fetch(step_, sampling);
    if (trial_is_change && steps % 2 != 0)  // taken for done when they were queued
      std::swap(system_.disks.position, system_.disks.trial_position);
    if (!sound) stop_unsound();
    if (stopped) renew_list();
  }

  void do_step(bool sampled) {
    double const strain = clock_.strain_since(list_, step_ + 1);
    double const next_strain = clock_.strain_since(list_, step_ + 2);
    if (drive_) drive_.before_end(system_, sampled);
    Real largest2 = system_.end_step(loops_, box_at(step_), box_at(step_ + 1), strain, next_strain);
    if (drive_ && drive_.after_end(system_))
      largest2 = std::max(largest2, farthest2(strain, next_strain));
    ++step_;
    if (largest2 == std::numeric_limits<Real>::max()) stop_unsound();
    double const widest = std::max(std::abs(strain), std::abs(next_strain));
    if (!list_holds(widest, largest2, skin_)) renew_list();
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
  void follow(RateChange const& change) {
    auto const [factor, rise] = change;
    auto const& disks = system_.disks;
    if (factor != 1)
      loops_.for_all("dynamics::ScaleMotion", disks.count(),
                     ScaleMotion<rotates, Space>{disks.motion, factor});
    if (rise != 0)
      loops_.for_all("dynamics::FollowFlow", disks.count(),
                     FollowFlow<rotates, Space>{disks.motion, disks.position, rise});
    double const strain = clock_.strain_since(list_, step_);
    double const next_strain = clock_.strain_since(list_, step_ + 1);
    if (!list_holds(std::abs(next_strain), farthest2(strain, next_strain), skin_)) renew_list();
  }

  void add_driven(Sums<rotates> const& sums, std::int64_t window, OpenWindows& windows) const {
    std::vector<Real> columns(std::begin(sums.value), std::end(sums.value));
    append(columns, drive_.power());
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
      failure::too_fast(clock_, step_, order_.original(static_cast<std::size_t>(farthest.loc)),
                        std::sqrt(farthest.val), skin_);
  }

  /// The list of the disks at the last build.
  void build_list() {
    auto& disks = system_.disks;
    auto const box = clock_.box(list_);
    auto const grid = make_cell_grid_in(room_, loops_.space, disks.at_build, box,
                                        big_diameter + skin_, order_.original());
    if (order_.sorts())
      order_.sort(loops_, grid, std::pair{&disks.position, &disks.trial_position},
                  std::pair{&disks.at_build, &disks.trial_position},
                  std::pair{&disks.motion, &disks.trial_motion},
                  std::pair{&disks.species, &other_species_});
    NeighborSearch<Space> const search{disks.at_build, disks.species, grid,
                                       system_.table,  box,           skin_};
    disks.neighbors =
        make_ranked_rows(loops_.space, search, std::move(disks.neighbors), order_.original());
  }

  Sums<rotates> measure() {
    auto const forces = system_.measured_forces(box_at(step_));
    if constexpr (trial_is_change) {
      if (drive_) return sums_of(drive_.measured(system_, forces));
    }
    return sums_of(forces);
  }

  template <class Forces>
  Sums<rotates> sums_of(Forces const& forces) {
    add_up(loops_, forces, 0);
    return to_host(totals_).front();
  }

  template <class Loops, class Forces>
  void add_up(Loops const& loops, Forces const& forces, std::int64_t place) const {
    AddUp<Forces, Space>{forces, disk_sums_, group_sums_, order_.original()}(loops, totals_, place);
  }

  State raw_state() const {
    auto const& disks = system_.disks;
    return state_of<rotates>(order_.in_first_order(to_host(disks.position)),
                             order_.in_first_order(to_host(disks.motion)), diameter_, clock_,
                             step_);
  }

  Launches<Space> loops_{};
  SteppedSystem<Law, Repulsion, Space, Scheme> system_;
  StepDrive<Law, Repulsion, Space, Scheme> drive_;
  double skin_;  ///< [d_s]
  RunClock clock_;
  std::int64_t step_ = 0;
  ShearMark list_;  ///< of its build
  std::int64_t builds_ = 0;
  std::vector<double> diameter_;  ///< kept on the host: files have it, steps do not need it
  LaunchPlan plan_;
  DiskOrder<Space> order_;
  CellGridRoom<Space> room_;
  Kokkos::View<Species*, Space> other_species_;  ///< [N] where disks are sorted
  LaunchQueue<Space> queue_;
  DeviceContacts<Space> contacts_;  ///< takes room where they are asked for
  SumsRow disk_sums_, group_sums_;  ///< [N], [groups_of_sums(N)], to work with
  SumsRow totals_;                  ///< of each configuration that is measured in a queue
};

}  // namespace bagnold
