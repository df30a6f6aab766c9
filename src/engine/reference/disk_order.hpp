// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "kernels/device/loops.hpp"
#include "kernels/device/neighbors/cell_grid.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

/// In which order disks lie in memory: that of the start, or sorted by cells of the box at every
/// list build, so that neighbours lie near each other. What is summed keeps the order of the start,
/// so no bit depends on it.
template <class Space>
class DiskOrder {
 public:
  template <class T>
  using Row = Kokkos::View<T*, Space>;

  /// That of the start, of a number of disks.
  DiskOrder(std::int64_t disks, bool sorts) : sorts_(sorts) {
    if (!sorts) return;
    std::vector<std::uint32_t> first(static_cast<std::size_t>(disks));
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = static_cast<std::uint32_t>(i);
    original_ = to_device<Space>("state::original", first);
    other_ = Row<std::uint32_t>("state::other_original", first.size());
  }

  bool sorts() const { return sorts_; }

  /// [N], the place in the order of the start of each disk; empty where it does not sort.
  Row<std::uint32_t> const& original() const { return original_; }

  /// Moves rows of values of the disks to the order of the members of a grid of these disks, each
  /// with a row of room, which the values are in afterwards; then the grid's members are in order.
  template <class... Pairs>
  void sort(Launches<Space> const& loops, CellGrid<Space> const& grid, Pairs&&... rows) {
    auto const count = static_cast<std::int64_t>(grid.members.extent(0));
    (move(loops, grid, count, *rows.first, *rows.second), ...);
    move(loops, grid, count, original_, other_);
    loops.for_all("neighbors::InOrder", count, InOrder{grid.members});
    on_host_.clear();
  }

  /// Place in the order of the start of the disk at a place in memory.
  std::size_t original(std::size_t place) const { return sorts_ ? on_host()[place] : place; }

  /// A row as it lies in memory in the order of the start.
  template <class T>
  std::vector<T> in_first_order(std::vector<T> row) const {
    if (!sorts_) return row;
    std::vector<T> sorted(row.size());
    for (std::size_t k = 0; k < row.size(); ++k) sorted[on_host()[k]] = row[k];
    return sorted;
  }

  // Functors are public: nvcc launches no others.

  template <class T>
  struct Gather {
    Row<T> from, to;
    Row<std::uint32_t> members;
    KOKKOS_FUNCTION void operator()(std::int64_t k) const { to(k) = from(members(k)); }
  };

  struct InOrder {
    Row<std::uint32_t> members;
    KOKKOS_FUNCTION void operator()(std::int64_t k) const {
      members(k) = static_cast<std::uint32_t>(k);
    }
  };

 private:
  template <class T>
  static void move(Launches<Space> const& loops, CellGrid<Space> const& grid, std::int64_t count,
                   Row<T>& values, Row<T>& room) {
    loops.for_all("neighbors::Gather", count, Gather<T>{values, room, grid.members});
    std::swap(values, room);
  }

  std::vector<std::uint32_t> const& on_host() const {
    if (on_host_.empty()) on_host_ = to_host(original_);
    return on_host_;
  }

  bool sorts_;
  Row<std::uint32_t> original_, other_;
  mutable std::vector<std::uint32_t> on_host_;  ///< empty: to be brought
};

}  // namespace bagnold
