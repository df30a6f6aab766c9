// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/verlet_list.hpp"
#include "kernels/physics/sums/sums.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/download_state.hpp"

/// What engines of all laws need of a backend, the same for each: compiled in compiled_once.cpp,
/// not again with every law.
namespace bagnold {

#define BAGNOLD_COMPILED_ONCE_FOR(KEYWORD, SPACE, ROTATES)                                   \
  KEYWORD template State download_state<ROTATES, SPACE>(                                     \
      Kokkos::View<Vec2<Real>*, SPACE> const&, Kokkos::View<Motion<ROTATES>*, SPACE> const&, \
      std::vector<double> const&, Clock const&, std::int64_t);                               \
  KEYWORD template Kokkos::View<Motion<ROTATES>*, SPACE> to_device<SPACE, Motion<ROTATES>>(  \
      std::string const&, std::vector<Motion<ROTATES>> const&);                              \
  KEYWORD template std::vector<Sums<ROTATES>> to_host<Sums<ROTATES>, SPACE>(                 \
      Kokkos::View<Sums<ROTATES>*, SPACE> const&);

#define BAGNOLD_COMPILED_ONCE(KEYWORD, SPACE)                                      \
  KEYWORD template void build_list<SPACE>(SPACE const&, VerletList<SPACE>&,        \
                                          Kokkos::View<Species*, SPACE> const&,    \
                                          SpeciesTable const&, ShearedBox const&); \
  KEYWORD template Kokkos::View<Vec2<Real>*, SPACE> to_device<SPACE, Vec2<Real>>(  \
      std::string const&, std::vector<Vec2<Real>> const&);                         \
  KEYWORD template Kokkos::View<Species*, SPACE> to_device<SPACE, Species>(        \
      std::string const&, std::vector<Species> const&);                            \
  KEYWORD template std::vector<Vec2<Real>> to_host<Vec2<Real>, SPACE>(             \
      Kokkos::View<Vec2<Real>*, SPACE> const&);                                    \
  BAGNOLD_COMPILED_ONCE_FOR(KEYWORD, SPACE, false)                                 \
  BAGNOLD_COMPILED_ONCE_FOR(KEYWORD, SPACE, true)

#ifdef KOKKOS_ENABLE_SERIAL
BAGNOLD_COMPILED_ONCE(extern, Kokkos::Serial)
#endif
#if defined(KOKKOS_ENABLE_OPENMP) && defined(BAGNOLD_BACKEND_OPENMP)
BAGNOLD_COMPILED_ONCE(extern, Kokkos::OpenMP)
#endif

}  // namespace bagnold
