// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/cell_grid.hpp"
#include "kernels/device/neighbors/neighbor_rows.hpp"
#include "kernels/device/side_by_side.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Calls visit(Neighbor) for every disk image within d_ij + skin of disk i.
///
/// The box must be at least 2 (d_max + skin) wide and high, so that a pair meets through one image
/// only. In rows above and below the box the query point is moved instead of the cells: three
/// columns hold all that is within reach, at any offset.
template <class Space>
struct NeighborSearch {
  Kokkos::View<Vec2<Real>*, Space> position;  ///< [N], in the box, [d_s]
  Kokkos::View<Species*, Space> species;      ///< [N]
  CellGrid<Space> grid;
  SpeciesTable table;
  ShearedBox box;  ///< offset in [0, L_x)
  Real skin;       ///< [d_s]

  template <class Visitor>
  KOKKOS_FUNCTION void operator()(std::uint32_t i, Visitor&& visit) const {
    if (grid.columns < 3 || grid.rows < 3) return all_pairs(i, visit);
    Vec2<Real> const point = position(i);
    int const row_i = grid.row(point.y);
    for (int step = -1; step <= 1; ++step) {
      int row = row_i + step;
      int const n = row < 0 ? -1 : (row >= grid.rows ? 1 : 0);
      row -= n * grid.rows;
      Real const x = point.x - n * box.offset;
      int const m = static_cast<int>(math::floor(x / box.length));
      int const column_i = grid.column(x - m * box.length);
      for (int side_step = -1; side_step <= 1; ++side_step) {
        int column = column_i + side_step;
        int const wrapped = column < 0 ? -1 : (column >= grid.columns ? 1 : 0);
        column -= wrapped * grid.columns;
        visit_cell(i, static_cast<std::int64_t>(row) * grid.columns + column, Image{m + wrapped, n},
                   visit);
      }
    }
  }

 private:
  template <class Visitor>
  KOKKOS_FUNCTION void visit_cell(std::uint32_t i, std::int64_t cell, Image const& image,
                                  Visitor&& visit) const {
    for (auto k = grid.first(cell); k < grid.first(cell + 1); ++k)
      visit_if_near(i, grid.members(k), image, visit);
  }

  /// For boxes too small for cells: every disk, every image.
  template <class Visitor>
  KOKKOS_FUNCTION void all_pairs(std::uint32_t i, Visitor&& visit) const {
    for (std::uint32_t j = 0; j < position.extent(0); ++j)
      for (int n = -1; n <= 1; ++n)
        for (int m = -2; m <= 2; ++m) visit_if_near(i, j, Image{m, n}, visit);
  }

  template <class Visitor>
  KOKKOS_FUNCTION void visit_if_near(std::uint32_t i, std::uint32_t j, Image const& image,
                                     Visitor&& visit) const {
    if (i == j) return;
    Vec2<Real> const separation = (position(i) - position(j)) - box.shift(image);
    Real const reach = (table.diameter[species(i)] + table.diameter[species(j)]) / 2 + skin;
    if (dot(separation, separation) < reach * reach) visit(Neighbor::make(j, image));
  }
};

/// Passes that find all rows: a body of a loop over disks each, with a scan of `row` between them.
namespace neighbor_rows {

template <class Space>
struct Count {
  NeighborSearch<Space> search;
  Kokkos::View<std::uint32_t*, Space> row;  ///< [N + 1]

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    std::uint32_t found = 0;
    search(static_cast<std::uint32_t>(i), [&](Neighbor const&) { ++found; });
    row(i + 1) = found;
  }
};

/// Each row sorted by neighbour index.
template <class Space>
struct Fill {
  NeighborSearch<Space> search;
  NeighborRows<Space> rows;

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    auto const& entries = rows.entries;
    auto const begin = rows.row(i);
    auto end = begin;
    search(static_cast<std::uint32_t>(i), [&](Neighbor const& neighbor) {
      auto slot = end++;
      for (; slot > begin && entries(slot - 1).packed > neighbor.packed; --slot)
        entries(slot) = entries(slot - 1);
      entries(slot) = neighbor;
    });
  }
};

}  // namespace neighbor_rows

/// All rows of neighbours within d_ij + skin, sorted by neighbour index.
template <class Space>
NeighborRows<Space> make_neighbor_rows(Space const& space, NeighborSearch<Space> const& search,
                                       NeighborRows<Space> rows) {
  using Range = Kokkos::RangePolicy<Space>;
  auto const count = static_cast<std::int64_t>(search.position.extent(0));
  if (rows.row.extent(0) == 0)
    rows.row = Kokkos::View<std::uint32_t*, Space>("neighbors::row", count + 1);

  side_by_side::parallel_for("neighbors::NeighborRows::count", Range(space, 0, count),
                             neighbor_rows::Count<Space>{search, rows.row});
  side_by_side::parallel_scan("neighbors::NeighborRows::scan", Range(space, 0, count + 1),
                              RunningSum<Space>{rows.row});
  std::uint32_t total = 0;
  Kokkos::deep_copy(space, total, Kokkos::subview(rows.row, count));
  space.fence();
  if (rows.entries.extent(0) < total) {
    rows.entries = {};  // free before asking for more
    rows.entries = Kokkos::View<Neighbor*, Space>(
        Kokkos::view_alloc(Kokkos::WithoutInitializing, "neighbors::entries"), total + total / 8);
  }
  side_by_side::parallel_for("neighbors::NeighborRows::fill", Range(space, 0, count),
                             neighbor_rows::Fill<Space>{search, rows});
  return rows;
}

}  // namespace bagnold
