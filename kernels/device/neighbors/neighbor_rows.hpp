// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

#include "kernels/physics/box/sheared_box.hpp"

namespace bagnold {

/// Every disk's neighbours, each pair in both rows, rows in the order of neighbour index.
template <class Space>
struct NeighborRows {
  Kokkos::View<std::uint32_t*, Space> row;  ///< [N + 1]: row i is entries row(i) .. row(i + 1) - 1
  Kokkos::View<Neighbor*, Space> entries;   ///< [row(N)] or more

  KOKKOS_FUNCTION std::uint32_t begin(std::uint32_t i) const { return row(i); }
  KOKKOS_FUNCTION std::uint32_t end(std::uint32_t i) const { return row(i + 1); }
  KOKKOS_FUNCTION Neighbor entry(std::uint32_t k) const { return entries(k); }
};

}  // namespace bagnold
