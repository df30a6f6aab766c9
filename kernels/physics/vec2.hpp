// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

namespace bagnold {

using Real = double;  ///< float32 positions are wrong below a rate of 1e-3: overlaps are ~ gammadot

/// A vector in the plane.
template <class T>
struct Vec2 {
  T x{};
  T y{};

  KOKKOS_FUNCTION constexpr Vec2& operator+=(Vec2 const& b) {
    x += b.x;
    y += b.y;
    return *this;
  }
};

template <class T>
KOKKOS_FUNCTION constexpr Vec2<T> operator+(Vec2<T> const& a, Vec2<T> const& b) {
  return {a.x + b.x, a.y + b.y};
}

template <class T>
KOKKOS_FUNCTION constexpr Vec2<T> operator-(Vec2<T> const& a, Vec2<T> const& b) {
  return {a.x - b.x, a.y - b.y};
}

template <class T>
KOKKOS_FUNCTION constexpr Vec2<T> operator*(T const& s, Vec2<T> const& a) {
  return {s * a.x, s * a.y};
}

template <class T>
KOKKOS_FUNCTION constexpr T dot(Vec2<T> const& a, Vec2<T> const& b) {
  return a.x * b.x + a.y * b.y;
}

/// z component of a x b.
template <class T>
KOKKOS_FUNCTION constexpr T cross(Vec2<T> const& a, Vec2<T> const& b) {
  return a.x * b.y - a.y * b.x;
}

/// z^ x a: a rotated by 90 degrees, counter-clockwise.
template <class T>
KOKKOS_FUNCTION constexpr Vec2<T> perpendicular(Vec2<T> const& a) {
  return {-a.y, a.x};
}

}  // namespace bagnold
