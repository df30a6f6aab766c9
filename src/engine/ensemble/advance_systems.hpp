// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/ensemble/system_run.hpp"

namespace bagnold {

/// Many systems in one launch, a team for each system. Positions, which a disk reads of all its
/// neighbours, are in team scratch if they fit; velocities are read only in contacts and stay in
/// memory.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
struct AdvanceSystems {
  /// A team of 512 leaves each of its threads 128 registers, of which it uses most.
  using Policy = Kokkos::TeamPolicy<Space, Kokkos::LaunchBounds<512, 1>>;
  using Run = SystemRun<Law, Repulsion, Space, Scheme>;
  using Team = typename Run::Team;

  EnsembleViews<Law::rotates, Space, Scheme> views;
  Kokkos::View<SystemConstants*, Space> constants;  ///< [S]
  Kokkos::View<SystemProgress*, Space> progress;    ///< [S]
  EnsembleRules<Law> rules;
  Sampling sampling;
  std::int64_t end;
  bool in_scratch;

  /// Team scratch for the positions and trial positions of a system, [bytes].
  static std::size_t scratch_size(std::size_t disks) { return 2 * disks * sizeof(Vec2<Real>); }

  KOKKOS_FUNCTION void operator()(Team const& team) const {
    auto const s = static_cast<std::int32_t>(team.league_rank());
    if (progress(s).wait != SystemProgress::Wait::none) return;
    auto const home = views.of(s);
    auto work = home;
    auto const count = static_cast<std::int32_t>(home.disks.position.extent(0));
    if (in_scratch) {
      auto* const scratch =
          static_cast<Vec2<Real>*>(team.team_scratch(0).get_shmem(2 * count * sizeof(Vec2<Real>)));
      work.disks.position = Kokkos::View<Vec2<Real>*, Space>(scratch, count);
      work.disks.trial_position = Kokkos::View<Vec2<Real>*, Space>(scratch + count, count);
      team::for_all(team, count,
                    [&](std::int32_t i) { work.disks.position(i) = home.disks.position(i); });
    }
    Run run(team, rules, constants(s), work, progress(s));
    run.advance(end, sampling);
    auto const reached = run.position();
    team::for_all(team, reached.data() == home.disks.position.data() ? 0 : count,
                  [&](std::int32_t i) { home.disks.position(i) = reached(i); });
    Kokkos::single(Kokkos::PerTeam(team), [&] { progress(s) = run.progress(); });
  }
};

}  // namespace bagnold
