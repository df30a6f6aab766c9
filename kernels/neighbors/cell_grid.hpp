// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/core/side_by_side.hpp"
#include "kernels/geometry/sheared_box.hpp"

namespace bagnold {

/// Disks sorted into square cells at least `reach` wide; inside a cell in the order of their index,
/// so that the grid does not depend on threads.
template <class Space>
struct CellGrid {
  int side = 0;     ///< cells along one edge of the box
  Real width = 0;   ///< of a cell, [d_s]
  Kokkos::View<std::uint32_t*, Space> first;    ///< [side^2 + 1]: cell c holds members first(c) ..
  Kokkos::View<std::uint32_t*, Space> members;  ///< [N] disk indices, cell by cell

  KOKKOS_FUNCTION int column(Real coordinate) const {
    int const c = static_cast<int>(coordinate / width);
    return c < 0 ? 0 : (c >= side ? side - 1 : c);  // rounding may leave a coordinate at L itself
  }

  KOKKOS_FUNCTION std::int64_t cell(Vec2<Real> const& point) const {
    return static_cast<std::int64_t>(column(point.y)) * side + column(point.x);
  }
};

namespace detail {

template <class Space>
void sort_cells(Space const& space, CellGrid<Space> const& grid) {
  side_by_side::parallel_for(
      "neighbors::CellGrid::sort",
      Kokkos::RangePolicy<Space>(space, 0, static_cast<std::int64_t>(grid.side) * grid.side),
      KOKKOS_LAMBDA(std::int64_t c) {
        for (auto k = grid.first(c) + 1; k < grid.first(c + 1); ++k) {
          std::uint32_t const member = grid.members(k);
          auto slot = k;
          for (; slot > grid.first(c) && grid.members(slot - 1) > member; --slot)
            grid.members(slot) = grid.members(slot - 1);
          grid.members(slot) = member;
        }
      });
}

}  // namespace detail

/// Sort disks into cells. position: [N], in the box, [d_s]; reach: [d_s].
template <class Space>
CellGrid<Space> make_cell_grid(Space const& space,
                               Kokkos::View<Vec2<Real>*, Space> const& position, Real length,
                               Real reach) {
  using Counts = Kokkos::View<std::uint32_t*, Space>;
  auto const count = static_cast<std::int64_t>(position.extent(0));
  CellGrid<Space> grid;
  Real const most = std::ceil(std::sqrt(static_cast<Real>(count)));  // a cell a disk is enough
  grid.side = static_cast<int>(std::clamp(length / reach, Real(1), std::max(Real(1), most)));
  grid.width = length / grid.side;
  auto const cells = static_cast<std::int64_t>(grid.side) * grid.side;
  grid.first = Counts("neighbors::first", cells + 1);
  grid.members = Counts("neighbors::members", count);
  Counts filled("neighbors::filled", cells);
  auto const g = grid;

  side_by_side::parallel_for(
      "neighbors::CellGrid::count", Kokkos::RangePolicy<Space>(space, 0, count),
      KOKKOS_LAMBDA(std::int64_t i) {
        auto const c = g.cell(position(i));
        Kokkos::atomic_fetch_add(&g.first(c + 1), 1u);
      });
  side_by_side::parallel_scan(
      "neighbors::CellGrid::scan", Kokkos::RangePolicy<Space>(space, 0, cells + 1),
      KOKKOS_LAMBDA(std::int64_t c, std::uint32_t& sum, bool last) {
        sum += g.first(c);
        if (last) g.first(c) = sum;
      });
  side_by_side::parallel_for(
      "neighbors::CellGrid::fill", Kokkos::RangePolicy<Space>(space, 0, count),
      KOKKOS_LAMBDA(std::int64_t i) {
        auto const c = g.cell(position(i));
        g.members(g.first(c) + Kokkos::atomic_fetch_add(&filled(c), 1u)) =
            static_cast<std::uint32_t>(i);
      });
  detail::sort_cells(space, grid);
  return grid;
}

}  // namespace bagnold
