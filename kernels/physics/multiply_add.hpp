// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// a b + c, rounded twice for plain numbers on every backend. Packs and other types of numbers have
/// their own, found by namespace; that of packs is rounded once if the processor can.
template <std::floating_point T>
KOKKOS_FORCEINLINE_FUNCTION constexpr T multiply_add(T a, T b, T c) {
  return a * b + c;
}

template <class T>
KOKKOS_FORCEINLINE_FUNCTION constexpr Vec2<T> multiply_add(T const& a, Vec2<T> const& b,
                                                           Vec2<T> const& c) {
  return {multiply_add(a, b.x, c.x), multiply_add(a, b.y, c.y)};
}

}  // namespace bagnold
