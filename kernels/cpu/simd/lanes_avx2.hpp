// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/level.hpp"

/// Four doubles in a register of AVX2, with fused multiply-add.
#if BAGNOLD_AVX2
namespace bagnold::simd {

using Lanes = double __attribute__((vector_size(32)));

/// Set of lanes: all bits of a lane, or none.
struct Mask {
  __m256d bits;

  friend Mask operator&(Mask a, Mask b) { return {_mm256_and_pd(a.bits, b.bits)}; }
  friend Mask operator|(Mask a, Mask b) { return {_mm256_or_pd(a.bits, b.bits)}; }
  BAGNOLD_INLINE unsigned lanes() const {  ///< lane k is bit k
    return static_cast<unsigned>(_mm256_movemask_pd(bits));
  }
  BAGNOLD_INLINE static Mask of(unsigned lanes) {
    __m256i const bit = _mm256_setr_epi64x(1, 2, 4, 8);
    __m256i const set = _mm256_and_si256(_mm256_set1_epi64x(lanes), bit);
    return {_mm256_castsi256_pd(_mm256_cmpeq_epi64(set, bit))};
  }
  BAGNOLD_INLINE bool any() const { return lanes() != 0; }
};

namespace detail {

BAGNOLD_INLINE Mask less(Lanes a, Lanes b) {
  return {_mm256_cmp_pd((__m256d)a, (__m256d)b, _CMP_LT_OQ)};
}
BAGNOLD_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) {
  return (Lanes)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
}
BAGNOLD_INLINE Lanes fused_negative(Lanes a, Lanes b, Lanes c) {
  return (Lanes)_mm256_fnmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
}
BAGNOLD_INLINE Lanes chosen(Mask mask, Lanes yes, Lanes no) {
  return (Lanes)_mm256_blendv_pd((__m256d)no, (__m256d)yes, mask.bits);
}
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes a) {
  return (Lanes)_mm256_and_pd(mask.bits, (__m256d)a);
}
BAGNOLD_INLINE Lanes larger(Lanes a, Lanes b) {
  return (Lanes)_mm256_max_pd((__m256d)b, (__m256d)a);
}
BAGNOLD_INLINE Lanes root(Lanes a) { return (Lanes)_mm256_sqrt_pd((__m256d)a); }
BAGNOLD_INLINE Lanes rounded_down(Lanes a) { return (Lanes)_mm256_floor_pd((__m256d)a); }

/// Division and root run beside the other units. An estimate refined by multiplications took up to
/// 20% longer.
BAGNOLD_INLINE Lanes inverse_root(Lanes a) { return Lanes{1, 1, 1, 1} / root(a); }

/// Eight numbers by n mod 8.
struct EightByNumber {
  __m256d low, high;
  BAGNOLD_INLINE explicit EightByNumber(double const* p)
      : low(_mm256_loadu_pd(p)), high(_mm256_loadu_pd(p + 4)) {}
};

/// Larger of two counts below 64 in each lane, given as a + 64 b.
struct LargerCounts {
  __m256i larger;

  BAGNOLD_INLINE explicit LargerCounts(Lanes both) {
    __m256i const counts = _mm256_set1_epi64x(63);
    // an integer is in the lowest bits of 2^52 + integer
    __m256i const bits =
        _mm256_castpd_si256(_mm256_add_pd((__m256d)both, _mm256_set1_pd(4503599627370496.0)));
    larger = _mm256_max_epi32(_mm256_and_si256(bits, counts),
                              _mm256_and_si256(_mm256_srli_epi64(bits, 6), counts));
  }

  /// table[n mod 8]: an entry of each half of the table by n mod 4, then one of the two by the
  /// third bit of n.
  BAGNOLD_INLINE Lanes look_up(EightByNumber const& table) const {
    __m256i const words = _mm256_or_si256(
        _mm256_slli_epi64(larger, 1),
        _mm256_add_epi64(_mm256_slli_epi64(larger, 33), _mm256_set1_epi64x(1LL << 32)));
    auto const look = [&](__m256d half) {
      return _mm256_castsi256_pd(_mm256_permutevar8x32_epi32(_mm256_castpd_si256(half), words));
    };
    return (Lanes)_mm256_blendv_pd(look(table.low), look(table.high),
                                   _mm256_castsi256_pd(_mm256_slli_epi64(larger, 61)));
  }
};

/// Rows of a 4 x 4 matrix to its columns.
BAGNOLD_INLINE void transpose(__m256d& a, __m256d& b, __m256d& c, __m256d& d) {
  __m256d const ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b);
  __m256d const cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
  a = _mm256_permute2f128_pd(ab0, cd0, 0x20);
  b = _mm256_permute2f128_pd(ab1, cd1, 0x20);
  c = _mm256_permute2f128_pd(ab0, cd0, 0x31);
  d = _mm256_permute2f128_pd(ab1, cd1, 0x31);
}
BAGNOLD_INLINE void transpose(Lanes* m) {
  __m256d a = (__m256d)m[0], b = (__m256d)m[1], c = (__m256d)m[2], d = (__m256d)m[3];
  transpose(a, b, c, d);
  m[0] = (Lanes)a, m[1] = (Lanes)b, m[2] = (Lanes)c, m[3] = (Lanes)d;
}

}  // namespace detail
}  // namespace bagnold::simd
#endif
