// SPDX-License-Identifier: BSD-3-Clause
#include <Kokkos_Core.hpp>

/// A View is assigned while it is empty. Needs no device and no running Kokkos.
int main() {
  using Array = Kokkos::View<double*, Kokkos::HostSpace>;
  Array first, second;
  first = second;
}
