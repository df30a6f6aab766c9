// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/physics/sums/sums.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/device_copy.hpp"

/// Templates that engines of all laws need from a backend. They do not depend on the law, so
/// compiled_once.cpp instantiates them once.
namespace bagnold {

#define BAGNOLD_COMPILED_ONCE_FOR(KEYWORD, SPACE, ROTATES)                                  \
  KEYWORD template Kokkos::View<Motion<ROTATES>*, SPACE> to_device<SPACE, Motion<ROTATES>>( \
      std::string const&, std::vector<Motion<ROTATES>> const&);                             \
  KEYWORD template std::vector<Sums<ROTATES>> to_host<Sums<ROTATES>, SPACE>(                \
      Kokkos::View<Sums<ROTATES>*, SPACE> const&);

#define BAGNOLD_COMPILED_ONCE(KEYWORD, SPACE)                                      \
  KEYWORD template CellGrid<SPACE> make_cell_grid_in<SPACE>(                       \
      CellGridRoom<SPACE>&, SPACE const&, Kokkos::View<Vec2<Real>*, SPACE> const&, \
      ShearedBox const&, Real, Kokkos::View<std::uint32_t*, SPACE> const&);        \
  KEYWORD template NeighborRows<SPACE> make_ranked_rows<SPACE>(                    \
      SPACE const&, NeighborSearch<SPACE> const&, NeighborRows<SPACE>,             \
      Kokkos::View<std::uint32_t*, SPACE> const&);                                 \
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
