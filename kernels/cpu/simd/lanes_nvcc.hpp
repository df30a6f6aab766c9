// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/level.hpp"

/// Lanes for nvcc, which parses host code again for the device, where vector types do not exist.
/// This code is parsed and never runs.
#ifdef __CUDA_ARCH__
namespace bagnold::simd {

template <class T>
struct alignas(8 * width) Several {
  T lane[width];
  T& operator[](int k);
  T operator[](int k) const;
};
template <class T>
Several<T> operator+(Several<T>, Several<T>);
template <class T>
Several<T> operator-(Several<T>, Several<T>);
template <class T>
Several<T> operator*(Several<T>, Several<T>);
template <class T>
Several<T> operator/(Several<T>, Several<T>);
template <class T>
Several<T> operator-(Several<T>);
template <class T>
Several<T> operator&(Several<T>, Several<T>);
template <class T>
Several<T> operator|(Several<T>, Several<T>);
template <class T>
Several<long long> operator<(Several<T>, Several<T>);
using Lanes = Several<double>;
using Bits = Several<long long>;
Lanes blend(Bits bits, Lanes yes, Lanes no);

/// Set of lanes: all bits of a lane, or none.
struct Mask {
  Bits bits;
  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  unsigned lanes() const {  ///< lane k is bit k
    unsigned all = 0;
    for (int k = 0; k < width; ++k) all |= (bits[k] ? 1u : 0u) << k;
    return all;
  }
  static Mask of(unsigned lanes) {
    Mask mask{};
    for (int k = 0; k < width; ++k) mask.bits[k] = lanes >> k & 1 ? -1 : 0;
    return mask;
  }
  bool any() const { return lanes() != 0; }
};

namespace detail {

BAGNOLD_INLINE Mask less(Lanes a, Lanes b) { return {a < b}; }
BAGNOLD_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) { return a * b + c; }
BAGNOLD_INLINE Lanes fused_negative(Lanes a, Lanes b, Lanes c) { return c - a * b; }
BAGNOLD_INLINE Lanes chosen(Mask mask, Lanes yes, Lanes no) { return blend(mask.bits, yes, no); }
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes a) { return blend(mask.bits, a, Lanes{}); }
BAGNOLD_INLINE Lanes larger(Lanes a, Lanes b) { return chosen(less(a, b), b, a); }
BAGNOLD_INLINE Lanes root(Lanes a) {
  for (int k = 0; k < width; ++k) a[k] = std::sqrt(a[k]);
  return a;
}
BAGNOLD_INLINE Lanes rounded_down(Lanes a) {
  for (int k = 0; k < width; ++k) a[k] = std::floor(a[k]);
  return a;
}
BAGNOLD_INLINE Lanes inverse_root(Lanes a) {
  for (int k = 0; k < width; ++k) a[k] = 1 / std::sqrt(a[k]);
  return a;
}

/// Eight numbers by n mod 8.
struct EightByNumber {
  double const* table;
  explicit EightByNumber(double const* p) : table(p) {}
};

/// Larger of two counts below 64 in each lane, given as a + 64 b.
struct LargerCounts {
  int larger[width];

  explicit LargerCounts(Lanes both) {
    for (int k = 0; k < width; ++k) {
      int const counts = static_cast<int>(both[k]);
      larger[k] = counts % 64 > counts / 64 ? counts % 64 : counts / 64;
    }
  }

  Lanes look_up(EightByNumber const& by) const {
    Lanes found{};
    for (int k = 0; k < width; ++k) found[k] = by.table[larger[k] % 8];
    return found;
  }
};

/// Rows of a matrix to its columns.
BAGNOLD_INLINE void transpose(Lanes* m) {
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < i; ++j) {
      double const moved = m[i][j];
      m[i][j] = m[j][i];
      m[j][i] = moved;
    }
}

}  // namespace detail
}  // namespace bagnold::simd
#endif
