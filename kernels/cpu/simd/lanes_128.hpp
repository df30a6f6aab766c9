// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/level.hpp"

/// Eight doubles in four registers of two, as every processor of today has them (SSE2, NEON).
#if BAGNOLD_128
namespace bagnold::simd {

using Two = double __attribute__((vector_size(16)));
using TwoBits = long long __attribute__((vector_size(16)));

struct Lanes {
  Two a, b, c, d;

  Lanes() = default;
  BAGNOLD_INLINE Lanes(Two k01, Two k23, Two k45, Two k67) : a(k01), b(k23), c(k45), d(k67) {}
  BAGNOLD_INLINE explicit Lanes(double x) : Lanes(Two{x, x}, Two{x, x}, Two{x, x}, Two{x, x}) {}
  BAGNOLD_INLINE Lanes(double s, double t, double u, double v, double w, double x, double y,
                       double z)
      : Lanes(Two{s, t}, Two{u, v}, Two{w, x}, Two{y, z}) {}

  BAGNOLD_INLINE double operator[](int k) const { return (&a)[k / 2][k % 2]; }
  BAGNOLD_INLINE double& operator[](int k) { return reinterpret_cast<double*>(this)[k]; }

  BAGNOLD_INLINE friend Lanes operator+(Lanes p, Lanes q) {
    return {p.a + q.a, p.b + q.b, p.c + q.c, p.d + q.d};
  }
  BAGNOLD_INLINE friend Lanes operator-(Lanes p, Lanes q) {
    return {p.a - q.a, p.b - q.b, p.c - q.c, p.d - q.d};
  }
  BAGNOLD_INLINE friend Lanes operator*(Lanes p, Lanes q) {
    return {p.a * q.a, p.b * q.b, p.c * q.c, p.d * q.d};
  }
  BAGNOLD_INLINE friend Lanes operator/(Lanes p, Lanes q) {
    return {p.a / q.a, p.b / q.b, p.c / q.c, p.d / q.d};
  }
  BAGNOLD_INLINE Lanes operator-() const { return {-a, -b, -c, -d}; }
};

namespace detail {

BAGNOLD_INLINE unsigned signs(TwoBits bits) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd((__m128d)bits));
#else
  return static_cast<unsigned>(bits[0] & 1) | static_cast<unsigned>(bits[1] & 2);
#endif
}

}  // namespace detail

/// Which lanes: all bits of a lane, or none.
struct Mask {
  TwoBits a, b, c, d;

  BAGNOLD_INLINE friend Mask operator&(Mask p, Mask q) {
    return {p.a & q.a, p.b & q.b, p.c & q.c, p.d & q.d};
  }
  BAGNOLD_INLINE friend Mask operator|(Mask p, Mask q) {
    return {p.a | q.a, p.b | q.b, p.c | q.c, p.d | q.d};
  }
  BAGNOLD_INLINE unsigned lanes() const {  ///< lane k is bit k
    using detail::signs;
    return signs(a) | signs(b) << 2 | signs(c) << 4 | signs(d) << 6;
  }
  BAGNOLD_INLINE static Mask of(unsigned lanes) {
    auto const two = [&](int k) {
      return -TwoBits{static_cast<long long>(lanes >> k & 1),
                      static_cast<long long>(lanes >> (k + 1) & 1)};
    };
    return {two(0), two(2), two(4), two(6)};
  }
  BAGNOLD_INLINE bool any() const {
    TwoBits const all = a | b | c | d;
    return (all[0] | all[1]) != 0;
  }
};

namespace detail {

BAGNOLD_INLINE Two both(TwoBits bits, Two x) { return (Two)(bits & (TwoBits)x); }
BAGNOLD_INLINE Two blend(TwoBits bits, Two yes, Two no) {
  return (Two)((bits & (TwoBits)yes) | (~bits & (TwoBits)no));
}

BAGNOLD_INLINE Mask less(Lanes p, Lanes q) { return {p.a < q.a, p.b < q.b, p.c < q.c, p.d < q.d}; }
#ifdef __ARM_FEATURE_FMA
BAGNOLD_INLINE Two fused(Two x, Two y, Two z) {
  return (Two)vfmaq_f64((float64x2_t)z, (float64x2_t)x, (float64x2_t)y);
}
BAGNOLD_INLINE Two fused_negative(Two x, Two y, Two z) {
  return (Two)vfmsq_f64((float64x2_t)z, (float64x2_t)x, (float64x2_t)y);
}
#else
BAGNOLD_INLINE Two fused(Two x, Two y, Two z) { return x * y + z; }
BAGNOLD_INLINE Two fused_negative(Two x, Two y, Two z) { return z - x * y; }
#endif
BAGNOLD_INLINE Lanes fused(Lanes p, Lanes q, Lanes r) {
  return {fused(p.a, q.a, r.a), fused(p.b, q.b, r.b), fused(p.c, q.c, r.c), fused(p.d, q.d, r.d)};
}
BAGNOLD_INLINE Lanes fused_negative(Lanes p, Lanes q, Lanes r) {
  return {fused_negative(p.a, q.a, r.a), fused_negative(p.b, q.b, r.b),
          fused_negative(p.c, q.c, r.c), fused_negative(p.d, q.d, r.d)};
}
BAGNOLD_INLINE Lanes chosen(Mask mask, Lanes yes, Lanes no) {
  return {blend(mask.a, yes.a, no.a), blend(mask.b, yes.b, no.b), blend(mask.c, yes.c, no.c),
          blend(mask.d, yes.d, no.d)};
}
BAGNOLD_INLINE Lanes kept(Mask mask, Lanes p) {
  return {both(mask.a, p.a), both(mask.b, p.b), both(mask.c, p.c), both(mask.d, p.d)};
}
BAGNOLD_INLINE Two root(Two x) {
#if defined(__SSE2__)
  return (Two)_mm_sqrt_pd((__m128d)x);
#elif defined(__ARM_NEON)
  return (Two)vsqrtq_f64((float64x2_t)x);
#else
  return Two{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}
BAGNOLD_INLINE Lanes root(Lanes p) { return {root(p.a), root(p.b), root(p.c), root(p.d)}; }
BAGNOLD_INLINE Two rounded_down(Two x) { return Two{std::floor(x[0]), std::floor(x[1])}; }
BAGNOLD_INLINE Lanes rounded_down(Lanes p) {
  return {rounded_down(p.a), rounded_down(p.b), rounded_down(p.c), rounded_down(p.d)};
}
BAGNOLD_INLINE Lanes inverse_root(Lanes p) { return Lanes(1.0) / root(p); }

/// The larger of two counts below 64 in a lane, a + 64 b.
struct LargerCounts {
  unsigned larger[width];

  BAGNOLD_INLINE explicit LargerCounts(Lanes both) {
    for (int k = 0; k < width; ++k) {
      auto const counts = static_cast<unsigned>(static_cast<int>(both[k]));
      unsigned const one = counts & 63, other = counts >> 6;
      larger[k] = one > other ? one : other;
    }
  }

  /// table[n mod 8]
  BAGNOLD_INLINE Lanes look_up(Lanes const& table) const {
    auto const at = [&](int k) { return (&table.a)[larger[k] % 8 / 2][larger[k] % 2]; };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
  }
};

BAGNOLD_INLINE Two firsts(Two x, Two y) { return __builtin_shuffle(x, y, TwoBits{0, 2}); }
BAGNOLD_INLINE Two seconds(Two x, Two y) { return __builtin_shuffle(x, y, TwoBits{1, 3}); }

/// Rows of an 8 x 8 matrix to its columns.
BAGNOLD_INLINE void transpose(Lanes* m) {
  Lanes turned[width];
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < width / 2; ++j) {
      Two const x = (&m[2 * j].a)[i / 2], y = (&m[2 * j + 1].a)[i / 2];
      (&turned[i].a)[j] = i % 2 == 0 ? firsts(x, y) : seconds(x, y);
    }
  for (int i = 0; i < width; ++i) m[i] = turned[i];
}

}  // namespace detail
}  // namespace bagnold::simd
#endif
