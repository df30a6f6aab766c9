// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/level.hpp"

/// Eight doubles in two registers of AVX2, with fused multiply-add.
#if BAGNOLD_AVX2
namespace bagnold::simd {

struct Lanes {
  __m256d low, high;

  Lanes() = default;
  BAGNOLD_INLINE Lanes(__m256d a, __m256d b) : low(a), high(b) {}
  BAGNOLD_INLINE explicit Lanes(double x) : low(_mm256_set1_pd(x)), high(low) {}
  BAGNOLD_INLINE Lanes(double a, double b, double c, double d, double e, double f, double g,
                       double h)
      : low(_mm256_setr_pd(a, b, c, d)), high(_mm256_setr_pd(e, f, g, h)) {}

  BAGNOLD_INLINE double operator[](int k) const { return k < 4 ? low[k] : high[k - 4]; }
  BAGNOLD_INLINE double& operator[](int k) { return reinterpret_cast<double*>(this)[k]; }

  friend Lanes operator+(Lanes a, Lanes b) { return {a.low + b.low, a.high + b.high}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.low - b.low, a.high - b.high}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.low * b.low, a.high * b.high}; }
  friend Lanes operator/(Lanes a, Lanes b) { return {a.low / b.low, a.high / b.high}; }
  BAGNOLD_INLINE Lanes operator-() const { return {-low, -high}; }
};

/// Which lanes: all bits of a lane, or none.
struct Mask {
  __m256d low, high;

  friend Mask operator&(Mask a, Mask b) {
    return {_mm256_and_pd(a.low, b.low), _mm256_and_pd(a.high, b.high)};
  }
  friend Mask operator|(Mask a, Mask b) {
    return {_mm256_or_pd(a.low, b.low), _mm256_or_pd(a.high, b.high)};
  }
  BAGNOLD_INLINE unsigned lanes() const {  ///< lane k is bit k
    return static_cast<unsigned>(_mm256_movemask_pd(low)) |
           static_cast<unsigned>(_mm256_movemask_pd(high)) << 4;
  }
  BAGNOLD_INLINE static Mask of(unsigned lanes) {
    __m256i const all = _mm256_set1_epi64x(lanes);
    auto const set = [&](__m256i bits) {
      return _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(all, bits), bits));
    };
    return {set(_mm256_setr_epi64x(1, 2, 4, 8)), set(_mm256_setr_epi64x(16, 32, 64, 128))};
  }
  BAGNOLD_INLINE bool any() const { return lanes() != 0; }
};

namespace detail {

BAGNOLD_INLINE Mask less(Lanes a, Lanes b) {
  return {_mm256_cmp_pd(a.low, b.low, _CMP_LT_OQ), _mm256_cmp_pd(a.high, b.high, _CMP_LT_OQ)};
}
BAGNOLD_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) {
  return {_mm256_fmadd_pd(a.low, b.low, c.low), _mm256_fmadd_pd(a.high, b.high, c.high)};
}
BAGNOLD_INLINE Lanes fused_negative(Lanes a, Lanes b, Lanes c) {
  return {_mm256_fnmadd_pd(a.low, b.low, c.low), _mm256_fnmadd_pd(a.high, b.high, c.high)};
}
BAGNOLD_INLINE Lanes chosen(Mask mask, Lanes yes, Lanes no) {
  return {_mm256_blendv_pd(no.low, yes.low, mask.low),
          _mm256_blendv_pd(no.high, yes.high, mask.high)};
}
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes a) {
  return {_mm256_and_pd(mask.low, a.low), _mm256_and_pd(mask.high, a.high)};
}
BAGNOLD_INLINE Lanes root(Lanes a) { return {_mm256_sqrt_pd(a.low), _mm256_sqrt_pd(a.high)}; }
BAGNOLD_INLINE Lanes rounded_down(Lanes a) {
  return {_mm256_floor_pd(a.low), _mm256_floor_pd(a.high)};
}

/// 1/sqrt(a) to about 1 ulp, the same on every processor: y from the exponent, to 3.4%, and two
/// steps of fourth order in e = 1 - a y^2,  y (1 + e/2 + 3 e^2/8 + 5 e^3/16), which leave 6.5e-6
/// and less than 1e-20.
BAGNOLD_INLINE Lanes inverse_root(Lanes a) {
  auto const rough = [](__m256d x) {
    __m256i const bits = _mm256_srli_epi64(_mm256_castpd_si256(x), 1);
    return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_set1_epi64x(0x5fe6eb50c7b537a9), bits));
  };
  Lanes const one(1.0);
  Lanes y = {rough(a.low), rough(a.high)};
  for (int step = 0; step < 2; ++step) {
    Lanes const e = fused_negative(a * y, y, one);
    Lanes const p = fused(fused(e, Lanes(0.3125), Lanes(0.375)), e, Lanes(0.5));
    y = fused(y * e, p, y);
  }
  return y;
}

/// The larger of two counts below 64 in a lane, a + 64 b.
struct LargerCounts {
  __m256i low, high;

  BAGNOLD_INLINE explicit LargerCounts(Lanes both) : low(of(both.low)), high(of(both.high)) {}

  /// table[n mod 8]
  BAGNOLD_INLINE Lanes look_up(Lanes const& table) const {
    return {at(table, low), at(table, high)};
  }

 private:
  BAGNOLD_INLINE static __m256i of(__m256d both) {
    __m256i const counts = _mm256_set1_epi64x(63);
    // whole numbers stand in the lowest bits of 2^52 + number
    __m256i const bits = _mm256_castpd_si256(both + _mm256_set1_pd(4503599627370496.0));
    return _mm256_max_epi32(_mm256_and_si256(bits, counts),
                            _mm256_and_si256(_mm256_srli_epi64(bits, 6), counts));
  }

  /// Both halves of the table by n mod 4, and of these one by the third bit of n.
  BAGNOLD_INLINE static __m256d at(Lanes const& table, __m256i n) {
    __m256i const words =
        _mm256_or_si256(_mm256_slli_epi64(n, 1),
                        _mm256_add_epi64(_mm256_slli_epi64(n, 33), _mm256_set1_epi64x(1LL << 32)));
    auto const look = [&](__m256d half) {
      return _mm256_castsi256_pd(_mm256_permutevar8x32_epi32(_mm256_castpd_si256(half), words));
    };
    return _mm256_blendv_pd(look(table.low), look(table.high),
                            _mm256_castsi256_pd(_mm256_slli_epi64(n, 61)));
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

/// Rows of an 8 x 8 matrix to its columns.
BAGNOLD_INLINE void transpose(Lanes* m) {
  transpose(m[0].low, m[1].low, m[2].low, m[3].low);
  transpose(m[4].high, m[5].high, m[6].high, m[7].high);
  transpose(m[0].high, m[1].high, m[2].high, m[3].high);
  transpose(m[4].low, m[5].low, m[6].low, m[7].low);
  for (int k = 0; k < 4; ++k) {
    __m256d const moved = m[k].high;
    m[k].high = m[k + 4].low;
    m[k + 4].low = moved;
  }
}

}  // namespace detail
}  // namespace bagnold::simd
#endif
