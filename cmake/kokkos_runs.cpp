// SPDX-License-Identifier: BSD-3-Clause
#include <Kokkos_Core.hpp>

/// A View is assigned while it is empty, and an empty one is made as an argument inside a generic
/// lambda. Needs no device and no running Kokkos.
using Array = Kokkos::View<double*, Kokkos::HostSpace>;

struct Rows {
  Array row, entries;
};

Rows longer(Rows rows) { return rows; }

int main() {
  Array first, second;
  first = second;
  auto const make = [](auto) { return longer(Rows{}); };
  return make(0).row.extent(0) == 0 ? 0 : 1;
}
