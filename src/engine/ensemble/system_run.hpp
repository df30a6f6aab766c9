// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/team.hpp"
#include "kernels/device/dynamics/list_renewal.hpp"
#include "kernels/device/dynamics/modified_velocity_verlet.hpp"
#include "kernels/device/dynamics/two_stage_leapfrog.hpp"
#include "kernels/device/neighbors/team_list.hpp"
#include "kernels/device/sums/team_sums.hpp"
#include "src/engine/ensemble/ensemble_views.hpp"
#include "src/engine/sampling.hpp"
#include "src/engine/ensemble/system_progress.hpp"

namespace bagnold {

/// The time loop of one system, run by the threads of a team, each with the same copy of this: the
/// steps of ReferenceEngine with barriers where that has launches.
template <ContactLaw Law, class Repulsion, class Space, Scheme Stepped>
class SystemRun {
 public:
  static constexpr bool rotates = Law::rotates;
  static constexpr bool two_stage = Stepped == Scheme::two_stage_leapfrog;
  using Team = typename Kokkos::TeamPolicy<Space>::member_type;
  using Views = SystemViews<rotates, Space, Stepped>;

  KOKKOS_FUNCTION SystemRun(Team const& team, EnsembleRules<Law> const& rules,
                            SystemConstants const& constants, Views const& views,
                            SystemProgress const& progress)
      : team_(team),
        rules_(rules),
        constants_(constants),
        views_(views),
        progress_(progress),
        since_(constants.clock.since(progress.list_step)),
        box_(box_at(progress.step)) {}

  KOKKOS_FUNCTION SystemProgress const& progress() const { return progress_; }
  /// Where the disks are: in the Views' positions or trial positions.
  KOKKOS_FUNCTION Kokkos::View<Vec2<Real>*, Space> position() const { return views_.position; }

  /// Steps on to `end`, or to where the host is needed.
  KOKKOS_FUNCTION void advance(std::int64_t end, Sampling const& sampling) {
    keep_list();
    auto next_sample = sampling.next(progress_.step);
    while (goes_on() && progress_.step < end) {
      bool const sampled = progress_.step == next_sample;
      if (sampled && progress_.samples == static_cast<std::int32_t>(views_.samples.extent(0)))
        progress_.wait = SystemProgress::Wait::for_samples;
      else if constexpr (two_stage)
        first_stage();
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
  using Position = Kokkos::View<Vec2<Real>*, Space>;
  using MotionView = Kokkos::View<Motion<rotates>*, Space>;
  using Forces = ContactForces<Law, Repulsion, Space>;
  using Farthest = Kokkos::MaxLoc<Real, std::int64_t>;

  KOKKOS_FUNCTION bool goes_on() const { return progress_.wait == SystemProgress::Wait::none; }

  KOKKOS_FUNCTION std::int32_t count() const {
    return static_cast<std::int32_t>(views_.position.extent(0));
  }

  KOKKOS_FUNCTION ShearedBox box_at(std::int64_t step) const {
    return {since_.length, since_.offset(step - progress_.list_step), constants_.clock.strain_rate};
  }

  KOKKOS_FUNCTION Forces forces(ShearedBox const& box, Position const& position,
                                MotionView const& motion) const {
    return {position,     motion, views_.species, views_.neighbors,
            rules_.table, box,    rules_.law,     Repulsion{}};
  }

  KOKKOS_FUNCTION Forces forces_now() const { return forces(box_, views_.position, views_.motion); }

  KOKKOS_FUNCTION ChangeForces<Law, Repulsion, Space> change_forces() const {
    return {forces_now(), views_.trial_motion, views_.step.contacts, views_.step.shares,
            constants_.clock.time_step};
  }

  /// The first stage of a two-stage step; the changes are in the trial motions.
  KOKKOS_FUNCTION void first_stage() {
    Real failed = 0;
    team::reduce(team_, count(),
                 FirstStage<Law, Repulsion, Space>{forces_now(), constants_.clock.time_step,
                                                  views_.trial_motion, views_.step.contacts},
                 Kokkos::Max<Real>(failed));
    if (failed > 0) progress_.wait = SystemProgress::Wait::unsound;
  }

  KOKKOS_FUNCTION void do_step() {
    Real const time_step = constants_.clock.time_step;
    auto const steps = progress_.step - progress_.list_step;
    ShearedBox const next_box = box_at(progress_.step + 1);
    Real const strain = since_.strain(steps + 1), next_strain = since_.strain(steps + 2);
    Real largest2 = 0;
    if constexpr (two_stage) {
      team::reduce(
          team_, count(),
          LeapOn<Law, Repulsion, Space>{change_forces(), time_step, views_.trial_position,
                                        views_.motion, views_.at_build, strain, next_strain},
          Kokkos::Max<Real>(largest2));
      Position const reached = views_.trial_position;
      views_.trial_position = views_.position;
      views_.position = reached;
    } else {
      team::for_all(team_, count(),
                    Predict<Law, Repulsion, Space>{forces_now(), time_step, views_.trial_position,
                                                   views_.trial_motion});
      team::reduce(team_, count(),
                   Correct<Law, Repulsion, Space>{
                       forces(next_box, views_.trial_position, views_.trial_motion), time_step,
                       views_.position, views_.motion, views_.at_build, strain, next_strain},
                   Kokkos::Max<Real>(largest2));
    }
    ++progress_.step;
    box_ = next_box;
    if (largest2 == Kokkos::reduction_identity<Real>::min()) {
      progress_.wait = SystemProgress::Wait::unsound;
      return;
    }
    Real const widest = math::fmax(math::fabs(strain), math::fabs(next_strain));
    if (!list_holds(widest, largest2, rules_.skin)) progress_.list = SystemProgress::List::lost;
  }

  KOKKOS_FUNCTION void keep_list() {
    if (progress_.list == SystemProgress::List::lost) take_into_box();
    if (progress_.list == SystemProgress::List::missing) build_list();
  }

  KOKKOS_FUNCTION void take_into_box() {
    progress_.list_step = progress_.step;
    since_ = constants_.clock.since(progress_.step);
    box_ = box_at(progress_.step);
    WrapDisks<rotates, Space> const wrap{box_, views_.position, views_.motion};
    auto const& views = views_;
    team::for_all(team_, count(), [&](std::int32_t i) {
      wrap(i);
      views.at_build(i) = views.position(i);
    });
    ++progress_.list_builds;
    progress_.list = SystemProgress::List::missing;
  }

  KOKKOS_FUNCTION void build_list() {
    CellGrid<Space> const grid{constants_.cells_along, since_.length / constants_.cells_along,
                               views_.cell_first, views_.cell_members};
    NeighborSearch<Space> const search{
        views_.at_build, views_.species, grid, rules_.table, box_at(progress_.list_step),
        rules_.skin};
    progress_.entries = TeamList<Space>{search, views_.cell_filled, views_.neighbors}(team_);
    if (progress_.entries > views_.neighbors.entries.extent(0)) {
      progress_.wait = SystemProgress::Wait::for_entries;
      return;
    }
    progress_.list = SystemProgress::List::stands;
    if (progress_.step == progress_.list_step) see_next_step();
  }

  KOKKOS_FUNCTION void see_next_step() {
    Real const strain = since_.strain(1);
    typename Farthest::value_type farthest;
    team::reduce(team_, count(),
                 NextStep<rotates, Space>{views_.position, views_.motion,
                                          constants_.clock.time_step, strain},
                 Farthest(farthest));
    if (list_holds(math::fabs(strain), farthest.val, rules_.skin)) return;
    progress_.wait = SystemProgress::Wait::too_fast;
    progress_.farthest = farthest;
  }

  KOKKOS_FUNCTION void measure() {
    if constexpr (two_stage)
      measure_with(change_forces());
    else
      measure_with(forces_now());
    ++progress_.samples;
  }

  template <class SomeForces>
  KOKKOS_FUNCTION void measure_with(SomeForces const& forces) {
    TeamSums<SomeForces, Space>{forces, views_.disk_sums, views_.block_sums}(
        team_, views_.samples(progress_.samples));
  }

  Team const& team_;
  EnsembleRules<Law> const& rules_;
  SystemConstants constants_;
  Views views_;
  SystemProgress progress_;
  ShearSince since_;
  ShearedBox box_;  ///< at progress_.step
};

}  // namespace bagnold
