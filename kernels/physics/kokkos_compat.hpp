// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

/// The few places where Kokkos 3.4 to 5.x differ.
namespace bagnold::math {

#if KOKKOS_VERSION >= 30700
using Kokkos::fabs;
using Kokkos::floor;
using Kokkos::fmax;
using Kokkos::sqrt;
#else
using Kokkos::Experimental::fabs;
using Kokkos::Experimental::floor;
using Kokkos::Experimental::fmax;
using Kokkos::Experimental::sqrt;
#endif

/// 1/sqrt(x)
KOKKOS_INLINE_FUNCTION double inverse_sqrt(double x) { return 1 / sqrt(x); }

KOKKOS_INLINE_FUNCTION double positive_part(double x) { return x > 0 ? x : 0; }

}  // namespace bagnold::math

namespace bagnold {

/// Start Kokkos with a number of host threads, without its advice on thread binding.
inline void initialize_kokkos(int threads) {
#if KOKKOS_VERSION >= 30700
  Kokkos::initialize(
      Kokkos::InitializationSettings().set_num_threads(threads).set_disable_warnings(true));
#else
  Kokkos::InitArguments arguments;
  arguments.num_threads = threads;
  arguments.disable_warnings = true;
  Kokkos::initialize(arguments);
#endif
}

}  // namespace bagnold
