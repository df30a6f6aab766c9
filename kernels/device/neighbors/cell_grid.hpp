// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/device/side_by_side.hpp"
#include "kernels/physics/box/sheared_box.hpp"

namespace bagnold {

/// Puts sums from the first entry on in the place of entries; the body of a scan.
template <class Space>
struct RunningSum {
  Kokkos::View<std::uint32_t*, Space> entries;

  KOKKOS_FUNCTION void operator()(std::int64_t k, std::uint32_t& sum, bool last) const {
    sum += entries(k);
    if (last) entries(k) = sum;
  }
};

/// Disks sorted into cells at least `reach` wide and high; inside a cell in the order of their
/// index, so that the grid does not depend on threads.
template <class Space>
struct CellGrid {
  int columns = 0, rows = 0;                    ///< cells along the box, and across it
  Real width = 0, height = 0;                   ///< of a cell, [d_s]
  Kokkos::View<std::uint32_t*, Space> first;    ///< [cells + 1]: cell c holds members first(c) ..
  Kokkos::View<std::uint32_t*, Space> members;  ///< [N] disk indices, cell by cell

  KOKKOS_FUNCTION int column(Real x) const { return within(x / width, columns); }
  KOKKOS_FUNCTION int row(Real y) const { return within(y / height, rows); }

  KOKKOS_FUNCTION std::int64_t cells() const { return static_cast<std::int64_t>(rows) * columns; }
  KOKKOS_FUNCTION std::int64_t cell(Vec2<Real> const& point) const {
    return static_cast<std::int64_t>(row(point.y)) * columns + column(point.x);
  }

 private:
  KOKKOS_FUNCTION static int within(Real place, int count) {
    int const c = static_cast<int>(place);
    return c < 0 ? 0 : (c >= count ? count - 1 : c);  // rounding may leave a coordinate at L itself
  }
};

/// Passes that sort disks into cells, in this order; `grid.first` and `filled` hold zeros before.
/// Each is a body of a loop: over disks, over cells and the end (a scan), over disks, over cells.
namespace cell_grid {

template <class Space>
struct Count {
  Kokkos::View<Vec2<Real>*, Space> position;  ///< [N], in the box, [d_s]
  CellGrid<Space> grid;

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    Kokkos::atomic_fetch_add(&grid.first(grid.cell(position(i)) + 1), 1u);
  }
};

template <class Space>
struct Fill {
  Kokkos::View<Vec2<Real>*, Space> position;
  CellGrid<Space> grid;
  Kokkos::View<std::uint32_t*, Space> filled;  ///< [cells]

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    auto const c = grid.cell(position(i));
    grid.members(grid.first(c) + Kokkos::atomic_fetch_add(&filled(c), 1u)) =
        static_cast<std::uint32_t>(i);
  }
};

/// By index, or by the rank of each disk where that is given.
template <class Space>
struct Sort {
  CellGrid<Space> grid;
  Kokkos::View<std::uint32_t*, Space> rank;  ///< [N], or empty

  KOKKOS_FUNCTION void operator()(std::int64_t c) const {
    for (auto k = grid.first(c) + 1; k < grid.first(c + 1); ++k) {
      std::uint32_t const member = grid.members(k);
      auto slot = k;
      for (; slot > grid.first(c) && rank_of(grid.members(slot - 1)) > rank_of(member); --slot)
        grid.members(slot) = grid.members(slot - 1);
      grid.members(slot) = member;
    }
  }

 private:
  KOKKOS_FUNCTION std::uint32_t rank_of(std::uint32_t member) const {
    return rank.extent(0) == 0 ? member : rank(member);
  }
};

}  // namespace cell_grid

/// Cells along an edge of a box, at least `reach` long; a cell a disk is enough. across: the length
/// of the other edge, [d_s].
inline int cells_along(Real length, Real across, Real reach, std::int64_t disks) {
  Real const most = std::ceil(std::sqrt(static_cast<Real>(disks) * (length / across)));
  return static_cast<int>(std::clamp(length / reach, Real(1), std::max(Real(1), most)));
}

/// Cells of a box, without disks in them.
template <class Space>
CellGrid<Space> empty_cell_grid(ShearedBox const& box, Real reach, std::int64_t disks) {
  CellGrid<Space> grid;
  grid.columns = cells_along(box.length, box.height, reach, disks);
  grid.rows = cells_along(box.height, box.length, reach, disks);
  grid.width = box.length / grid.columns;
  grid.height = box.height / grid.rows;
  return grid;
}

/// Memory for a grid, kept from one to the next.
template <class Space>
struct CellGridRoom {
  Kokkos::View<std::uint32_t*, Space> first, members, filled;  ///< [cells + 1], [N], [cells + 1]

  /// Zeros in all but members.
  void make(Space const& space, std::int64_t cells, std::int64_t disks) {
    using Counts = Kokkos::View<std::uint32_t*, Space>;
    if (static_cast<std::int64_t>(first.extent(0)) != cells + 1 ||
        static_cast<std::int64_t>(members.extent(0)) != disks) {
      first = Counts("neighbors::first", cells + 1);
      filled = Counts("neighbors::filled", cells + 1);
      members = Counts("neighbors::members", disks);
    } else {
      Kokkos::deep_copy(space, first, 0u);
      Kokkos::deep_copy(space, filled, 0u);
    }
  }
};

/// Sort disks into cells, in `room`. position: [N], in the box, [d_s]; reach: [d_s]; rank: [N], the
/// order inside a cell, or empty: by index.
template <class Space>
CellGrid<Space> make_cell_grid_in(CellGridRoom<Space>& room, Space const& space,
                                  Kokkos::View<Vec2<Real>*, Space> const& position,
                                  ShearedBox const& box, Real reach,
                                  Kokkos::View<std::uint32_t*, Space> const& rank) {
  using Range = Kokkos::RangePolicy<Space>;
  auto const count = static_cast<std::int64_t>(position.extent(0));
  auto grid = empty_cell_grid<Space>(box, reach, count);
  auto const cells = grid.cells();
  room.make(space, cells, count);
  grid.first = room.first;
  grid.members = room.members;
  auto const& filled = room.filled;

  side_by_side::parallel_for("neighbors::CellGrid::count", Range(space, 0, count),
                             cell_grid::Count<Space>{position, grid});
  side_by_side::parallel_scan("neighbors::CellGrid::scan", Range(space, 0, cells + 1),
                              RunningSum<Space>{grid.first});
  side_by_side::parallel_for("neighbors::CellGrid::fill", Range(space, 0, count),
                             cell_grid::Fill<Space>{position, grid, filled});
  side_by_side::parallel_for("neighbors::CellGrid::sort", Range(space, 0, cells),
                             cell_grid::Sort<Space>{grid, rank});
  return grid;
}

/// Makes a cell grid in memory of its own, by index.
template <class Space>
CellGrid<Space> make_cell_grid(Space const& space, Kokkos::View<Vec2<Real>*, Space> const& position,
                               ShearedBox const& box, Real reach) {
  CellGridRoom<Space> room;
  Kokkos::View<std::uint32_t*, Space> const by_index;
  return make_cell_grid_in(room, space, position, box, reach, by_index);
}

}  // namespace bagnold
