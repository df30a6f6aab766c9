// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// In place of Kokkos' header of this name: what formulas of kernels/physics take from it, for the
/// host alone.
#define KOKKOS_FUNCTION
#define KOKKOS_INLINE_FUNCTION inline
#define KOKKOS_FORCEINLINE_FUNCTION inline
