// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/physics/box/list_criterion.hpp"

namespace bagnold {

/// A neighbour list and the positions it was built from.
template <class Space>
struct VerletList {
  Real skin = 0;                              ///< [d_s]
  Kokkos::View<Vec2<Real>*, Space> at_build;  ///< [N], in the box, [d_s]
  NeighborRows<Space> rows;
};

/// The list of the disks at list.at_build (in the box), with box.offset in [0, L_x).
template <class Space>
void build_list(Space const& space, VerletList<Space>& list,
                Kokkos::View<Species*, Space> const& species, SpeciesTable const& table,
                ShearedBox const& box) {
  auto const grid = make_cell_grid(space, list.at_build, box, big_diameter + list.skin);
  NeighborSearch<Space> const search{list.at_build, species, grid, table, box, list.skin};
  list.rows = make_neighbor_rows(space, search, list.rows);
}

}  // namespace bagnold
