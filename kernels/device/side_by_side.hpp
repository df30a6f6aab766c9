// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>
#include <string>
#include <type_traits>

/// Loops that several host threads may run at once on Serial, each for a system of its own.
///
/// Kokkos::Serial up to 4.0 keeps one scratch for the reductions and scans of the whole process,
/// and later ones let only one thread at a time into a loop. So on Serial these loops are written
/// out, in the order of Kokkos: the bits are the same. Elsewhere they are those of Kokkos.
namespace bagnold::side_by_side {

#ifdef KOKKOS_ENABLE_SERIAL
template <class Space>
inline constexpr bool written_out = std::is_same_v<Space, Kokkos::Serial>;
#else
template <class Space>
inline constexpr bool written_out = false;
#endif

/// body(i)
template <class Policy, class Body>
void parallel_for(std::string const& label, Policy const& policy, Body const& body) {
  if constexpr (written_out<typename Policy::execution_space>)
    for (auto i = policy.begin(); i < policy.end(); ++i) body(i);
  else
    Kokkos::parallel_for(label, policy, body);
}

/// body(i, value&), the values joined by a reducer of Kokkos.
template <class Policy, class Body, class Reducer>
void parallel_reduce(std::string const& label, Policy const& policy, Body const& body,
                     Reducer const& reducer) {
  if constexpr (written_out<typename Policy::execution_space>) {
    auto& value = reducer.reference();
    reducer.init(value);
    for (auto i = policy.begin(); i < policy.end(); ++i) body(i, value);
  } else {
    Kokkos::parallel_reduce(label, policy, body, reducer);
  }
}

/// body(i, sum&, true), the sums being integers.
template <class Policy, class Body>
void parallel_scan(std::string const& label, Policy const& policy, Body const& body) {
  if constexpr (written_out<typename Policy::execution_space>) {
    std::uint32_t sum = 0;
    for (auto i = policy.begin(); i < policy.end(); ++i) body(i, sum, true);
  } else {
    Kokkos::parallel_scan(label, policy, body);
  }
}

}  // namespace bagnold::side_by_side
