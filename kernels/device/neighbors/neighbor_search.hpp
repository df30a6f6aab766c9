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
    Query const query(*this, i);
    if (grid.columns < 3 || grid.rows < 3) return all_pairs(query, visit);
    Vec2<Real> const point = query.point;
    int const row_i = grid.row(point.y);
    for (int step = -1; step <= 1; ++step) {
      int row = row_i + step;
      int const n = row < 0 ? -1 : (row >= grid.rows ? 1 : 0);
      row -= n * grid.rows;
      Real const x = point.x - n * box.offset;
      int const m = static_cast<int>(math::floor(x / box.length));
      int const column_i = grid.column(x - m * box.length);
      auto const cells = [&](int first, int last, int wrapped) {
        visit_cells(query, static_cast<std::int64_t>(row) * grid.columns + first, last - first + 1,
                    Image{m + wrapped, n}, visit);
      };
      int const last = grid.columns - 1;
      if (column_i == 0) cells(last, last, -1);
      cells(column_i == 0 ? 0 : column_i - 1, column_i == last ? last : column_i + 1, 0);
      if (column_i == last) cells(0, 0, 1);
    }
  }

 private:
  /// Data of a disk that all its candidates share.
  struct Query {
    std::uint32_t disk;
    Vec2<Real> point;
    Real reach2[2];  ///< by the other's species

    KOKKOS_FUNCTION Query(NeighborSearch const& search, std::uint32_t i)
        : disk(i), point(search.position(i)) {
      for (int s = 0; s < 2; ++s) {
        Real const reach =
            (search.table.diameter[search.species(i)] + search.table.diameter[s]) / 2 + search.skin;
        reach2[s] = reach * reach;
      }
    }
  };

  /// Cells side by side: their members lie one after the other.
  template <class Visitor>
  KOKKOS_FUNCTION void visit_cells(Query const& query, std::int64_t first, int count,
                                   Image const& image, Visitor&& visit) const {
    Vec2<Real> const shift = box.shift(image);
    auto const end = grid.first(first + count);
    for (auto k = grid.first(first); k < end; ++k)
      visit_if_near(query, grid.members(k), image, shift, visit);
  }

  /// For boxes too small for cells: every disk, every image.
  template <class Visitor>
  KOKKOS_FUNCTION void all_pairs(Query const& query, Visitor&& visit) const {
    for (std::uint32_t j = 0; j < position.extent(0); ++j)
      for (int n = -1; n <= 1; ++n)
        for (int m = -2; m <= 2; ++m)
          visit_if_near(query, j, Image{m, n}, box.shift(Image{m, n}), visit);
  }

  template <class Visitor>
  KOKKOS_FUNCTION void visit_if_near(Query const& query, std::uint32_t j, Image const& image,
                                     Vec2<Real> const& shift, Visitor&& visit) const {
    Vec2<Real> const separation = (query.point - position(j)) - shift;
    if (dot(separation, separation) < query.reach2[species(j)] && j != query.disk)
      visit(Neighbor::make(j, image, species(j) != 0));
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

/// Each row sorted by neighbour index, or by the rank of each disk where that is given.
template <class Space>
struct Fill {
  NeighborSearch<Space> search;
  NeighborRows<Space> rows;
  Kokkos::View<std::uint32_t*, Space> rank;  ///< [N], or empty

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    auto const& entries = rows.entries;
    auto const begin = rows.row(i);
    auto end = begin;
    search(static_cast<std::uint32_t>(i), [&](Neighbor const& neighbor) {
      auto slot = end++;
      auto const own = rank_of(neighbor);
      for (; slot > begin && rank_of(entries(slot - 1)) > own; --slot)
        entries(slot) = entries(slot - 1);
      entries(slot) = neighbor;
    });
  }

 private:
  KOKKOS_FUNCTION std::uint32_t rank_of(Neighbor neighbor) const {
    return rank.extent(0) == 0 ? neighbor.packed : rank(neighbor.index());
  }
};

}  // namespace neighbor_rows

/// All rows of neighbours within d_ij + skin, in the memory of `rows` as far as that goes; sorted
/// by the rank of each disk, [N], or by neighbour index where that is empty.
template <class Space>
NeighborRows<Space> make_ranked_rows(Space const& space, NeighborSearch<Space> const& search,
                                     NeighborRows<Space> rows,
                                     Kokkos::View<std::uint32_t*, Space> const& rank) {
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
                             neighbor_rows::Fill<Space>{search, rows, rank});
  return rows;
}

/// Neighbour rows, sorted by neighbour index.
template <class Space>
NeighborRows<Space> make_neighbor_rows(Space const& space, NeighborSearch<Space> const& search,
                                       NeighborRows<Space> const& rows) {
  Kokkos::View<std::uint32_t*, Space> const by_index;
  return make_ranked_rows(space, search, rows, by_index);
}

}  // namespace bagnold
