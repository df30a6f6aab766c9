// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/level.hpp"

/// Eight doubles in a register of AVX-512.
#if BAGNOLD_AVX512
namespace bagnold::simd {

using Lanes = double __attribute__((vector_size(64)));

/// Set of lanes.
struct Mask {
  __mmask8 bits;
  friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
  friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
  unsigned lanes() const { return bits; }  ///< lane k is bit k
  static Mask of(unsigned lanes) { return {static_cast<__mmask8>(lanes)}; }
  bool any() const { return bits != 0; }
};

namespace detail {

BAGNOLD_INLINE Mask less(Lanes a, Lanes b) {
  return {_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ)};
}
BAGNOLD_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) {
  return (Lanes)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
}
BAGNOLD_INLINE Lanes fused_negative(Lanes a, Lanes b, Lanes c) {
  return (Lanes)_mm512_fnmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
}
BAGNOLD_INLINE Lanes chosen(Mask mask, Lanes yes, Lanes no) {
  return (Lanes)_mm512_mask_blend_pd(mask.bits, (__m512d)no, (__m512d)yes);
}
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes a) {
  return (Lanes)_mm512_maskz_mov_pd(mask.bits, (__m512d)a);
}
BAGNOLD_INLINE Lanes larger(Lanes a, Lanes b) {
  return (Lanes)_mm512_max_pd((__m512d)b, (__m512d)a);
}
BAGNOLD_INLINE Lanes root(Lanes a) { return (Lanes)_mm512_sqrt_pd((__m512d)a); }
BAGNOLD_INLINE Lanes rounded_down(Lanes a) {
  return (Lanes)_mm512_roundscale_pd((__m512d)a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}

/// 1/sqrt(a) to about 1 ulp: an estimate y of 14 bits and one step of fourth order in
/// e = 1 - a y^2,  y (1 + e/2 + 3 e^2/8 + 5 e^3/16), which leaves 35 e^4/128 < 7e-17.
BAGNOLD_INLINE Lanes inverse_root(Lanes a) {
  Lanes const one = {1, 1, 1, 1, 1, 1, 1, 1};
  Lanes const y = (Lanes)_mm512_rsqrt14_pd((__m512d)a);
  Lanes const e = fused_negative(a * y, y, one);
  Lanes const p = fused(fused(e, 0.3125 * one, 0.375 * one), e, 0.5 * one);
  return fused(y * e, p, y);
}

/// Eight numbers by n mod 8.
struct EightByNumber {
  __m512d all;
  BAGNOLD_INLINE explicit EightByNumber(double const* p) : all(_mm512_loadu_pd(p)) {}
};

/// Larger of two counts below 64 in each lane, given as a + 64 b.
struct LargerCounts {
  __m512i larger;

  BAGNOLD_INLINE explicit LargerCounts(Lanes both) {
    auto const counts = _mm512_set1_epi64(63);
    auto const bits =
        _mm512_castpd_si512(  // whole numbers stand in the lowest bits of 2^52 + number
            _mm512_add_pd((__m512d)both, _mm512_set1_pd(4503599627370496.0)));
    larger = _mm512_max_epi64(_mm512_and_si512(bits, counts),
                              _mm512_and_si512(_mm512_srli_epi64(bits, 6), counts));
  }

  BAGNOLD_INLINE Lanes look_up(EightByNumber const& table) const {
    return (Lanes)_mm512_permutexvar_pd(larger, table.all);
  }
};

/// Rows of an 8 x 8 matrix to its columns.
BAGNOLD_INLINE void transpose(Lanes* m) {
  __m512d pairs[width];  // even and odd columns of two rows, side by side
  for (int k = 0; k < width; k += 2) {
    pairs[k] = _mm512_unpacklo_pd((__m512d)m[k], (__m512d)m[k + 1]);
    pairs[k + 1] = _mm512_unpackhi_pd((__m512d)m[k], (__m512d)m[k + 1]);
  }
  for (int odd = 0; odd < 2; ++odd) {
    __m512d const* const p = pairs + odd;
    __m512d const a = _mm512_shuffle_f64x2(p[0], p[2], 0x88),
                  b = _mm512_shuffle_f64x2(p[4], p[6], 0x88);
    __m512d const c = _mm512_shuffle_f64x2(p[0], p[2], 0xdd),
                  d = _mm512_shuffle_f64x2(p[4], p[6], 0xdd);
    m[odd] = (Lanes)_mm512_shuffle_f64x2(a, b, 0x88);
    m[odd + 4] = (Lanes)_mm512_shuffle_f64x2(a, b, 0xdd);
    m[odd + 2] = (Lanes)_mm512_shuffle_f64x2(c, d, 0x88);
    m[odd + 6] = (Lanes)_mm512_shuffle_f64x2(c, d, 0xdd);
  }
}

}  // namespace detail
}  // namespace bagnold::simd
#endif
