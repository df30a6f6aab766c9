// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/compiled_once.hpp"

namespace bagnold {

#ifdef KOKKOS_ENABLE_SERIAL
BAGNOLD_COMPILED_ONCE(, Kokkos::Serial)
#endif
#if defined(KOKKOS_ENABLE_OPENMP) && defined(BAGNOLD_BACKEND_OPENMP)
BAGNOLD_COMPILED_ONCE(, Kokkos::OpenMP)
#endif

}  // namespace bagnold
