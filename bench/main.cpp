// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "kernels/core/kokkos_compat.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  bagnold::initialize_kokkos(1);
  benchmark::RunSpecifiedBenchmarks();
  Kokkos::finalize();
}
