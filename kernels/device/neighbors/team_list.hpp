// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/device/team.hpp"

namespace bagnold {

/// The list of one system, built by a team: the passes of build_list.
template <class Space>
struct TeamList {
  NeighborSearch<Space> search;
  Kokkos::View<std::uint32_t*, Space> filled;  ///< [cells or more], for the team's use
  NeighborRows<Space> rows;                    ///< row: [N + 1], begins with 0

  /// Returns the neighbours of all disks together; where that is more than rows.entries has room
  /// for, there is no list.
  template <class Team>
  KOKKOS_FUNCTION std::uint32_t operator()(Team const& members) const {
    auto const count = static_cast<std::int32_t>(search.position.extent(0));
    sort_into_cells(members, count);
    team::for_all(members, count, neighbor_rows::Count<Space>{search, rows.row});
    team::scan(members, count + 1, RunningSum<Space>{rows.row});
    std::uint32_t const total = rows.row(count);
    if (total <= rows.entries.extent(0))
      team::for_all(members, count, neighbor_rows::Fill<Space>{search, rows, {}});
    return total;
  }

 private:
  struct Clear {
    Kokkos::View<std::uint32_t*, Space> first, filled;
    KOKKOS_FUNCTION void operator()(std::int32_t c) const { first(c) = filled(c) = 0; }
  };

  template <class Team>
  KOKKOS_FUNCTION void sort_into_cells(Team const& members, std::int32_t count) const {
    auto const& grid = search.grid;
    auto const cells = static_cast<std::int32_t>(grid.cells());
    team::for_all(members, cells + 1, Clear{grid.first, filled});
    team::for_all(members, count, cell_grid::Count<Space>{search.position, grid});
    team::scan(members, cells + 1, RunningSum<Space>{grid.first});
    team::for_all(members, count, cell_grid::Fill<Space>{search.position, grid, filled});
    team::for_all(members, cells, cell_grid::Sort<Space>{grid, {}});
  }
};

}  // namespace bagnold
