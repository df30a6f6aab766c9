// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512DQ__) && !defined(__CUDA_ARCH__)
#include <immintrin.h>
#define BAGNOLD_AVX512 1
#else
#define BAGNOLD_AVX512 0
#endif

/// Eight doubles side by side: the one place that knows the instruction set. Arithmetic is the
/// compiler's vector extension, which runs on any processor; a few operations have AVX-512 forms.
/// A call in a pack loop costs more than the pack: registers go to memory and back.
#define BAGNOLD_INLINE [[gnu::always_inline]] inline

namespace bagnold::simd {

inline constexpr int width = 8;

/// The next multiple of the width.
constexpr std::uint32_t round_up(std::uint32_t n) { return (n + width - 1) / width * width; }

#ifndef __CUDA_ARCH__
using Lanes = double __attribute__((vector_size(64)));
using Bits = long long __attribute__((vector_size(64)));

BAGNOLD_INLINE Lanes blend(Bits bits, Lanes yes, Lanes no) { return bits ? yes : no; }
#else
/// nvcc reads host code once more for the device, which knows no vectors: declared, and not used.
template <class T>
struct alignas(64) Eight {
  T lane[width];
  T& operator[](int k);
  T operator[](int k) const;
  Eight& operator+=(Eight);
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
#endif

/// Which lanes.
struct Mask {
#if BAGNOLD_AVX512
  __mmask8 bits;
  friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
  friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
  unsigned lanes() const { return bits; }  ///< lane k is bit k
  static Mask of(unsigned lanes) { return {static_cast<__mmask8>(lanes)}; }
#else
  Bits bits;
  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  unsigned lanes() const {
    unsigned all = 0;
    for (int k = 0; k < width; ++k) all |= (bits[k] ? 1u : 0u) << k;
    return all;
  }
  static Mask of(unsigned lanes) {
    Mask mask{};
    for (int k = 0; k < width; ++k) mask.bits[k] = lanes >> k & 1 ? -1 : 0;
    return mask;
  }
#endif
  bool any() const { return lanes() != 0; }
};

struct Pack {
  Lanes v;

  Pack() = default;
  Pack(Lanes lanes) : v(lanes) {}
  Pack(double x) : v(Lanes{x, x, x, x, x, x, x, x}) {}

  static Pack load(double const* p) {
    Pack r;
    __builtin_memcpy(&r.v, p, sizeof r.v);
    return r;
  }
  void store(double* p) const { __builtin_memcpy(p, &v, sizeof v); }

  friend Pack operator+(Pack a, Pack b) { return a.v + b.v; }
  friend Pack operator-(Pack a, Pack b) { return a.v - b.v; }
  friend Pack operator*(Pack a, Pack b) { return a.v * b.v; }
  friend Pack operator/(Pack a, Pack b) { return a.v / b.v; }
  friend Pack operator-(Pack a) { return -a.v; }
  Pack& operator+=(Pack b) {
    v += b.v;
    return *this;
  }
#if BAGNOLD_AVX512
  friend Mask operator<(Pack a, Pack b) {
    return {_mm512_cmp_pd_mask((__m512d)a.v, (__m512d)b.v, _CMP_LT_OQ)};
  }
#else
  friend Mask operator<(Pack a, Pack b) { return {a.v < b.v}; }
#endif
};

/// a b + c, rounded once where the machine can.
BAGNOLD_INLINE Pack fma(Pack a, Pack b, Pack c) {
#if BAGNOLD_AVX512
  return (Lanes)_mm512_fmadd_pd((__m512d)a.v, (__m512d)b.v, (__m512d)c.v);
#else
  return a.v * b.v + c.v;
#endif
}

/// The same by the name that kernels/physics calls.
BAGNOLD_INLINE Pack multiply_add(Pack a, Pack b, Pack c) { return fma(a, b, c); }

/// c - a b
BAGNOLD_INLINE Pack fnma(Pack a, Pack b, Pack c) {
#if BAGNOLD_AVX512
  return (Lanes)_mm512_fnmadd_pd((__m512d)a.v, (__m512d)b.v, (__m512d)c.v);
#else
  return c.v - a.v * b.v;
#endif
}

BAGNOLD_INLINE Pack select(Mask mask, Pack yes, Pack no) {
#if BAGNOLD_AVX512
  return (Lanes)_mm512_mask_blend_pd(mask.bits, (__m512d)no.v, (__m512d)yes.v);
#else
  return blend(mask.bits, yes.v, no.v);
#endif
}

/// a where the mask is set, else 0, whatever a is there.
BAGNOLD_INLINE Pack zero_unless(Mask mask, Pack a) {
#if BAGNOLD_AVX512
  return (Lanes)_mm512_maskz_mov_pd(mask.bits, (__m512d)a.v);
#else
  return select(mask, a, Pack(0.0));
#endif
}

/// The first `count` lanes, all if there are no more.
BAGNOLD_INLINE Mask first_lanes(std::uint32_t count) {
  return Mask::of(count < width ? (1u << count) - 1 : (1u << width) - 1);
}

BAGNOLD_INLINE Pack max(Pack a, Pack b) { return select(a < b, b, a); }

BAGNOLD_INLINE Pack positive_part(Pack a) { return select(Pack(0.0) < a, a, 0.0); }

BAGNOLD_INLINE double largest(Pack a) {
  double largest = a.v[0];
  for (int k = 1; k < width; ++k) largest = largest < a.v[k] ? a.v[k] : largest;
  return largest;
}

/// The sum of the lanes, first to last.
BAGNOLD_INLINE double sum(Pack a) {
  double sum = 0;
  for (int k = 0; k < width; ++k) sum += a.v[k];
  return sum;
}

BAGNOLD_INLINE Pack sqrt(Pack a) {
#if BAGNOLD_AVX512
  return (Lanes)_mm512_sqrt_pd((__m512d)a.v);
#else
  Pack r;
  for (int k = 0; k < width; ++k) r.v[k] = std::sqrt(a.v[k]);
  return r;
#endif
}

BAGNOLD_INLINE Pack floor(Pack a) {
#if BAGNOLD_AVX512
  return (Lanes)_mm512_roundscale_pd((__m512d)a.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
#else
  Pack r;
  for (int k = 0; k < width; ++k) r.v[k] = std::floor(a.v[k]);
  return r;
#endif
}

/// 1/sqrt(a), to about 1 ulp: an estimate y of 14 bits and one step of fourth order in
/// e = 1 - a y^2,  y (1 + e/2 + 3 e^2/8 + 5 e^3/16), which leaves 35 e^4/128 < 7e-17.
BAGNOLD_INLINE Pack inverse_sqrt(Pack a) {
#if BAGNOLD_AVX512
  Pack const y = (Lanes)_mm512_rsqrt14_pd((__m512d)a.v);
  Pack const e = fnma(a * y, y, 1.0);
  Pack const p = fma(fma(e, 0.3125, 0.375), e, 0.5);
  return fma(y * e, p, y);
#else
  return 1.0 / sqrt(a);
#endif
}

/// Two counts a lane, as one number a + base b: 1 to 8 each.
struct CountPairs {
  static constexpr int base = 64;
#if BAGNOLD_AVX512
  __m512i larger;

  BAGNOLD_INLINE explicit CountPairs(Pack both) {
    auto const counts = _mm512_set1_epi64(base - 1);
    auto const bits =
        _mm512_castpd_si512(  // whole numbers stand in the lowest bits of 2^52 + number
            _mm512_add_pd((__m512d)both.v, _mm512_set1_pd(4503599627370496.0)));
    larger = _mm512_max_epi64(_mm512_and_si512(bits, counts),
                              _mm512_and_si512(_mm512_srli_epi64(bits, 6), counts));
  }

  /// table[n mod 8], n the larger of the two.
  BAGNOLD_INLINE Pack look_up_larger(Pack const& table) const {
    return (Lanes)_mm512_permutexvar_pd(larger, (__m512d)table.v);
  }
#else
  int larger[width];

  explicit CountPairs(Pack both) {
    for (int k = 0; k < width; ++k) {
      int const counts = static_cast<int>(both.v[k]);
      larger[k] = counts % base > counts / base ? counts % base : counts / base;
    }
  }
  Pack look_up_larger(Pack const& table) const {
    Pack r;
    for (int k = 0; k < width; ++k) r.v[k] = table.v[larger[k] % width];
    return r;
  }
#endif
};

/// Rows of an 8 x 8 matrix, m[8], to its columns.
BAGNOLD_INLINE void transpose(Pack* m) {
#if BAGNOLD_AVX512
  __m512d pairs[width];  // even and odd columns of two rows, side by side
  for (int k = 0; k < width; k += 2) {
    pairs[k] = _mm512_unpacklo_pd((__m512d)m[k].v, (__m512d)m[k + 1].v);
    pairs[k + 1] = _mm512_unpackhi_pd((__m512d)m[k].v, (__m512d)m[k + 1].v);
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
#else
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < i; ++j) {
      double const moved = m[i].v[j];
      m[i].v[j] = m[j].v[i];
      m[j].v[i] = moved;
    }
#endif
}

}  // namespace bagnold::simd
