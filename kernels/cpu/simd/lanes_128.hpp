// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/cpu/simd/level.hpp"

/// Two doubles in a register (SSE2, NEON).
#if BAGNOLD_128
namespace bagnold::simd {

using Lanes = double __attribute__((vector_size(16)));

/// Set of lanes: all bits of a lane, or none.
struct Mask {
  using Bits = long long __attribute__((vector_size(16)));
  Bits bits;

  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  BAGNOLD_INLINE unsigned lanes() const {  ///< lane k is bit k
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_pd((__m128d)bits));
#else
    return static_cast<unsigned>(bits[0] & 1) | static_cast<unsigned>(bits[1] & 2);
#endif
  }
  BAGNOLD_INLINE static Mask of(unsigned lanes) {
    return {-Bits{static_cast<long long>(lanes & 1), static_cast<long long>(lanes >> 1 & 1)}};
  }
  BAGNOLD_INLINE bool any() const { return lanes() != 0; }
};

namespace detail {

BAGNOLD_INLINE Mask less(Lanes a, Lanes b) { return {a < b}; }
#ifdef __ARM_FEATURE_FMA
BAGNOLD_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) {
  return (Lanes)vfmaq_f64((float64x2_t)c, (float64x2_t)a, (float64x2_t)b);
}
BAGNOLD_INLINE Lanes fused_negative(Lanes a, Lanes b, Lanes c) {
  return (Lanes)vfmsq_f64((float64x2_t)c, (float64x2_t)a, (float64x2_t)b);
}
#else
BAGNOLD_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) { return a * b + c; }
BAGNOLD_INLINE Lanes fused_negative(Lanes a, Lanes b, Lanes c) { return c - a * b; }
#endif
BAGNOLD_INLINE Lanes chosen(Mask mask, Lanes yes, Lanes no) {
  return (Lanes)((mask.bits & (Mask::Bits)yes) | (~mask.bits & (Mask::Bits)no));
}
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes a) { return (Lanes)(mask.bits & (Mask::Bits)a); }
BAGNOLD_INLINE Lanes larger(Lanes a, Lanes b) {
#ifdef __SSE2__
  return (Lanes)_mm_max_pd((__m128d)b, (__m128d)a);
#else
  return chosen(less(a, b), b, a);
#endif
}
BAGNOLD_INLINE Lanes root(Lanes a) {
#if defined(__SSE2__)
  return (Lanes)_mm_sqrt_pd((__m128d)a);
#elif defined(__ARM_NEON)
  return (Lanes)vsqrtq_f64((float64x2_t)a);
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
}
BAGNOLD_INLINE Lanes rounded_down(Lanes a) { return Lanes{std::floor(a[0]), std::floor(a[1])}; }
BAGNOLD_INLINE Lanes inverse_root(Lanes a) { return Lanes{1, 1} / root(a); }

/// Eight numbers by n mod 8.
struct EightByNumber {
  double const* table;
  BAGNOLD_INLINE explicit EightByNumber(double const* p) : table(p) {}
};

/// Larger of two counts below 64 in each lane, given as a + 64 b.
struct LargerCounts {
  unsigned larger[width];

  BAGNOLD_INLINE explicit LargerCounts(Lanes both) {
    for (int k = 0; k < width; ++k) {
      auto const counts = static_cast<unsigned>(static_cast<int>(both[k]));
      unsigned const one = counts & 63, other = counts >> 6;
      larger[k] = one > other ? one : other;
    }
  }

  BAGNOLD_INLINE Lanes look_up(EightByNumber const& by) const {
    return Lanes{by.table[larger[0] % 8], by.table[larger[1] % 8]};
  }
};

BAGNOLD_INLINE Lanes firsts(Lanes a, Lanes b) { return Lanes{a[0], b[0]}; }
BAGNOLD_INLINE Lanes seconds(Lanes a, Lanes b) { return Lanes{a[1], b[1]}; }

/// Rows of a 2 x 2 matrix to its columns.
BAGNOLD_INLINE void transpose(Lanes* m) {
  Lanes const first = firsts(m[0], m[1]);
  m[1] = seconds(m[0], m[1]);
  m[0] = first;
}

}  // namespace detail
}  // namespace bagnold::simd
#endif
