// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/scale_motion.hpp"
#include "kernels/device/dynamics/stepped_system.hpp"
#include "kernels/device/neighbors/team_list.hpp"
#include "kernels/device/sums/add_up.hpp"
#include "kernels/device/team.hpp"
#include "src/engine/ensemble/ensemble_views.hpp"
#include "src/engine/ensemble/system_progress.hpp"
#include "src/engine/sampling.hpp"

namespace bagnold {

/// Time loop of one system, run by the threads of a team, each with the same copy of this struct:
/// the steps of ReferenceEngine, where that uses launches.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
class SystemRun {
 public:
  static constexpr bool rotates = Law::rotates;
  using Team = typename Kokkos::TeamPolicy<Space>::member_type;
  using Views = SystemViews<rotates, Space, Scheme>;

  KOKKOS_FUNCTION SystemRun(Team const& team, EnsembleRules<Law> const& rules,
                            SystemConstants const& constants, Views const& views,
                            SystemProgress const& progress)
      : team_(team),
        loops_{team},
        rules_(rules),
        constants_(constants),
        views_(views),
        system_{views.disks, rules.table, rules.law, constants.clock.time_step},
        progress_(progress),
        since_(constants.clock.since(progress.list_mark)),
        box_(box_at(progress.step)) {}

  KOKKOS_FUNCTION SystemProgress const& progress() const { return progress_; }
  /// Present positions of the disks: the Views' positions or trial positions.
  KOKKOS_FUNCTION Kokkos::View<Vec2<Real>*, Space> position() const {
    return system_.disks.position;
  }

  /// Steps to `end`, or to where the host is needed, for example at a change of the strain rate.
  KOKKOS_FUNCTION void advance(std::int64_t end, Sampling const& sampling) {
    if (constants_.rate_end < end) end = constants_.rate_end;
    if (progress_.factor != 1) change_rate();
    keep_list();
    auto next_sample = sampling.next(progress_.step);
    while (goes_on() && progress_.step < end) {
      bool const sampled = progress_.step == next_sample;
      if (sampled && progress_.samples == static_cast<std::int32_t>(views_.samples.extent(0)))
        progress_.wait = SystemProgress::Wait::for_samples;
      else if (!system_.begin_step(loops_, box_))
        progress_.wait = SystemProgress::Wait::unsound;
      if (!goes_on()) return;
      if (sampled) {
        measure();
        next_sample = sampling.next(next_sample + 1);
      }
      do_step();
      if (goes_on()) keep_list();
    }
  }

 private:
  KOKKOS_FUNCTION bool goes_on() const { return progress_.wait == SystemProgress::Wait::none; }

  KOKKOS_FUNCTION ShearedBox box_at(std::int64_t step) const {
    Clock const& clock = constants_.clock;
    return {clock.box_length, since_.offset(step), clock.strain_rate,
            clock.box_aspect * clock.box_length};
  }

  KOKKOS_FUNCTION void do_step() {
    auto const step = progress_.step;
    ShearedBox const next_box = box_at(step + 1);
    Real const strain = since_.strain(step + 1), next_strain = since_.strain(step + 2);
    Real const largest2 = system_.end_step(loops_, box_, next_box, strain, next_strain);
    ++progress_.step;
    box_ = next_box;
    if (largest2 == Kokkos::reduction_identity<Real>::min()) {
      progress_.wait = SystemProgress::Wait::unsound;
      return;
    }
    Real const widest = math::fmax(math::fabs(strain), math::fabs(next_strain));
    if (!list_holds(widest, largest2, rules_.skin)) progress_.list = SystemProgress::List::lost;
  }

  /// Changes the strain rate; the list stays if it is still valid for a step.
  KOKKOS_FUNCTION void change_rate() {
    auto const& disks = system_.disks;
    loops_.for_all("dynamics::ScaleMotion", disks.count(),
                   ScaleMotion<rotates, Space>{disks.motion, progress_.factor});
    progress_.factor = 1;
    Real const strain = since_.strain(progress_.step);
    Real const next_strain = since_.strain(progress_.step + 1);
    Real largest2 = 0;
    loops_.reduce("dynamics::Farthest", disks.count(),
                  Farthest<rotates, Space>{disks.position, disks.motion, disks.at_build,
                                           constants_.clock.time_step, strain, next_strain},
                  Kokkos::Max<Real>(largest2));
    if (!list_holds(math::fabs(next_strain), largest2, rules_.skin))
      progress_.list = SystemProgress::List::lost;
  }

  KOKKOS_FUNCTION void keep_list() {
    if (progress_.list == SystemProgress::List::lost) take_into_box();
    if (progress_.list == SystemProgress::List::missing) build_list();
  }

  KOKKOS_FUNCTION void take_into_box() {
    progress_.list_mark = constants_.clock.mark(progress_.step);
    since_ = constants_.clock.since(progress_.list_mark);
    box_ = box_at(progress_.step);
    system_.take_into_box(loops_, box_);
    ++progress_.list_builds;
    progress_.list = SystemProgress::List::missing;
  }

  KOKKOS_FUNCTION void build_list() {
    ShearedBox const box = constants_.clock.box(progress_.list_mark);
    CellGrid<Space> const grid{
        constants_.columns,           constants_.rows,   box.length / constants_.columns,
        box.height / constants_.rows, views_.cell_first, views_.cell_members};
    NeighborSearch<Space> const search{
        system_.disks.at_build, system_.disks.species, grid, rules_.table, box, rules_.skin};
    progress_.entries = TeamList<Space>{search, views_.cell_filled, system_.disks.neighbors}(team_);
    if (progress_.entries > system_.disks.neighbors.entries.extent(0)) {
      progress_.wait = SystemProgress::Wait::for_entries;
      return;
    }
    progress_.list = SystemProgress::List::stands;
    if (progress_.step == progress_.list_mark.step) see_next_step();
  }

  KOKKOS_FUNCTION void see_next_step() {
    Real const strain = since_.strain(progress_.step + 1);
    auto const farthest = system_.farthest_of_next_step(loops_, strain);
    if (list_holds(math::fabs(strain), farthest.val, rules_.skin)) return;
    progress_.wait = SystemProgress::Wait::too_fast;
    progress_.farthest = farthest;
  }

  KOKKOS_FUNCTION void measure() {
    auto const forces = system_.measured_forces(box_);
    AddUp<std::remove_cv_t<decltype(forces)>, Space>{
        forces, views_.disk_sums, views_.group_sums, {}}(loops_, views_.samples, progress_.samples);
    ++progress_.samples;
  }

  Team const& team_;
  TeamLoops<Team> loops_;
  EnsembleRules<Law> const& rules_;
  SystemConstants constants_;
  Views views_;
  SteppedSystem<Law, Repulsion, Space, Scheme> system_;
  SystemProgress progress_;
  ShearSince since_;
  ShearedBox box_;  ///< at progress_.step
};

}  // namespace bagnold
