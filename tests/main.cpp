// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kernels/device/initialize_kokkos.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  bagnold::initialize_kokkos(2);
  int const failed = RUN_ALL_TESTS();
  Kokkos::finalize();
  return failed;
}
