// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <cmath>

/// Functions of numbers for host and device, without Kokkos itself, so that formulas compile fast.
namespace bagnold::math {

KOKKOS_INLINE_FUNCTION double fabs(double x) { return ::fabs(x); }
KOKKOS_INLINE_FUNCTION double floor(double x) { return ::floor(x); }
KOKKOS_INLINE_FUNCTION double fmax(double x, double y) { return ::fmax(x, y); }
KOKKOS_INLINE_FUNCTION double sqrt(double x) { return ::sqrt(x); }

/// 1/sqrt(x)
KOKKOS_INLINE_FUNCTION double inverse_sqrt(double x) { return 1 / sqrt(x); }

KOKKOS_INLINE_FUNCTION double positive_part(double x) { return x > 0 ? x : 0; }

}  // namespace bagnold::math
