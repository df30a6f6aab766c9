// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

namespace bagnold {

/// A value for each disk of each system: a system's part lies in one piece on every backend.
template <class T, class Space>
using SystemTable = Kokkos::View<T**, Kokkos::LayoutRight, Space>;

/// One system's part of a table; it does not keep the table alive.
template <class T, class Space>
KOKKOS_FUNCTION Kokkos::View<T*, Space> part(SystemTable<T, Space> const& table,
                                             std::size_t system) {
  return Kokkos::View<T*, Space>(table.data() + system * table.extent(1), table.extent(1));
}

}  // namespace bagnold
