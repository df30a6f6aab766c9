// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <string_view>
#include <tuple>

#include "kernels/physics/type_list.hpp"

namespace bagnold {

/// Name of an execution space in input and output.
template <class Space>
inline constexpr std::string_view backend_name = "?";

namespace detail {
using SerialBackend =
#ifdef KOKKOS_ENABLE_SERIAL
    std::tuple<Kokkos::Serial>;
#else
    std::tuple<>;
#endif
using OpenMPBackend =
#if defined(KOKKOS_ENABLE_OPENMP) && defined(BAGNOLD_BACKEND_OPENMP)
    std::tuple<Kokkos::OpenMP>;
#else
    std::tuple<>;
#endif
using CudaBackend =
#if defined(KOKKOS_ENABLE_CUDA) && defined(BAGNOLD_BACKEND_CUDA)
    std::tuple<Kokkos::Cuda>;
#else
    std::tuple<>;
#endif
}  // namespace detail

#ifdef KOKKOS_ENABLE_SERIAL
template <>
inline constexpr std::string_view backend_name<Kokkos::Serial> = "serial";
#endif
#ifdef KOKKOS_ENABLE_OPENMP
template <>
inline constexpr std::string_view backend_name<Kokkos::OpenMP> = "openmp";
#endif
#ifdef KOKKOS_ENABLE_CUDA
template <>
inline constexpr std::string_view backend_name<Kokkos::Cuda> = "cuda";
#endif

/// True if a backend works in memory that the host cannot access.
template <class Space>
inline constexpr bool is_device =
    !Kokkos::SpaceAccessibility<Kokkos::HostSpace, typename Space::memory_space>::accessible;

/// All execution spaces of this build.
using Backends = decltype(std::tuple_cat(detail::SerialBackend{}, detail::OpenMPBackend{},
                                         detail::CudaBackend{}));
static_assert(std::tuple_size_v<Backends> > 0, "no backend: Kokkos has none of those asked for");

/// make(std::type_identity<Space>) for the backend of that name; an empty Made if the build does
/// not have it.
template <class Made, class Make>
Made on_backend(std::string_view backend, Make const& make) {
  Made made;
  for_each_type<Backends>([&]<class Space>(std::type_identity<Space> space) {
    if (backend == backend_name<Space>) made = make(space);
  });
  return made;
}

}  // namespace bagnold
