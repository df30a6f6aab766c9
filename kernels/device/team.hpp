// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

/// Loops that the threads of one team share. After each all have waited for each other, and see
/// what each has written.
namespace bagnold::team {

/// body(k), k < count
template <class Team, class Body>
KOKKOS_FUNCTION void for_all(Team const& team, std::int32_t count, Body const& body) {
  Kokkos::parallel_for(Kokkos::TeamThreadRange(team, count), body);
  team.team_barrier();
}

/// body(k, value&), the values joined by a reducer of Kokkos; each thread has the result.
template <class Team, class Body, class Reducer>
KOKKOS_FUNCTION void reduce(Team const& team, std::int32_t count, Body const& body,
                            Reducer const& reducer) {
  Kokkos::parallel_reduce(Kokkos::TeamThreadRange(team, count), body, reducer);
  team.team_barrier();
}

/// body(k, sum&, last), as Kokkos has it.
template <class Team, class Body>
KOKKOS_FUNCTION void scan(Team const& team, std::int32_t count, Body const& body) {
  Kokkos::parallel_scan(Kokkos::TeamThreadRange(team, count), body);
  team.team_barrier();
}

}  // namespace bagnold::team
