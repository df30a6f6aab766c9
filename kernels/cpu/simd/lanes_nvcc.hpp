// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/level.hpp"

/// nvcc reads host code once more for the device, which knows no vectors: this is there to be read,
/// and never runs.
#ifdef __CUDA_ARCH__
namespace bagnold::simd {

template <class T>
struct alignas(64) Eight {
  T lane[width];
  T& operator[](int k);
  T operator[](int k) const;
};
template <class T>
Eight<T> operator+(Eight<T>, Eight<T>);
template <class T>
Eight<T> operator-(Eight<T>, Eight<T>);
template <class T>
Eight<T> operator*(Eight<T>, Eight<T>);
template <class T>
Eight<T> operator/(Eight<T>, Eight<T>);
template <class T>
Eight<T> operator-(Eight<T>);
template <class T>
Eight<T> operator&(Eight<T>, Eight<T>);
template <class T>
Eight<T> operator|(Eight<T>, Eight<T>);
template <class T>
Eight<long long> operator<(Eight<T>, Eight<T>);
using Lanes = Eight<double>;
using Bits = Eight<long long>;
Lanes blend(Bits bits, Lanes yes, Lanes no);

/// Which lanes: all bits of a lane, or none.
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
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes a) {
  return blend(mask.bits, a, Lanes{0, 0, 0, 0, 0, 0, 0, 0});
}
BAGNOLD_INLINE Lanes root(Lanes a) {
  for (int k = 0; k < width; ++k) a[k] = std::sqrt(a[k]);
  return a;
}
BAGNOLD_INLINE Lanes rounded_down(Lanes a) {
  for (int k = 0; k < width; ++k) a[k] = std::floor(a[k]);
  return a;
}
BAGNOLD_INLINE Lanes inverse_root(Lanes a) { return Lanes{1, 1, 1, 1, 1, 1, 1, 1} / root(a); }

/// The larger of two counts below 64 in a lane, a + 64 b.
struct LargerCounts {
  int larger[width];

  explicit LargerCounts(Lanes both) {
    for (int k = 0; k < width; ++k) {
      int const counts = static_cast<int>(both[k]);
      larger[k] = counts % 64 > counts / 64 ? counts % 64 : counts / 64;
    }
  }

  /// table[n mod 8]
  Lanes look_up(Lanes const& table) const {
    Lanes found{};
    for (int k = 0; k < width; ++k) found[k] = table[larger[k] % width];
    return found;
  }
};

/// Rows of an 8 x 8 matrix to its columns.
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
