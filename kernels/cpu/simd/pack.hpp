// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "kernels/cpu/simd/lanes_128.hpp"
#include "kernels/cpu/simd/lanes_avx2.hpp"
#include "kernels/cpu/simd/lanes_avx512.hpp"

/// Packs: as many doubles as a register of the processor holds. Their operations are in one header
/// for each instruction set.
namespace bagnold::simd {

namespace detail {

template <class Number, int... Ks>
BAGNOLD_INLINE Lanes lanes_of(Number const& number, std::integer_sequence<int, Ks...>) {
  return Lanes{number(Ks)...};
}

/// number(k) in lane k.
template <class Number>
BAGNOLD_INLINE Lanes lanes_of(Number const& number) {
  return lanes_of(number, std::make_integer_sequence<int, width>{});
}

}  // namespace detail

struct Pack {
  Lanes v;

  Pack() = default;
  Pack(Lanes lanes) : v(lanes) {}
  Pack(double x) : v(detail::lanes_of([x](int) { return x; })) {}

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
    v = v + b.v;
    return *this;
  }
  friend Mask operator<(Pack a, Pack b) { return detail::less(a.v, b.v); }
};

/// a b + c, rounded once if the processor can.
BAGNOLD_INLINE Pack fma(Pack a, Pack b, Pack c) { return detail::fused(a.v, b.v, c.v); }

/// fma() under the name that kernels/physics uses.
BAGNOLD_INLINE Pack multiply_add(Pack a, Pack b, Pack c) { return fma(a, b, c); }

/// c - a b
BAGNOLD_INLINE Pack fnma(Pack a, Pack b, Pack c) { return detail::fused_negative(a.v, b.v, c.v); }

BAGNOLD_INLINE Pack select(Mask mask, Pack yes, Pack no) {
  return detail::chosen(mask, yes.v, no.v);
}

/// a where the mask is set, else 0, even if a is NaN there.
BAGNOLD_INLINE Pack zero_unless(Mask mask, Pack a) { return detail::kept(mask, a.v); }

/// Mask of the first `count` lanes, at most all.
BAGNOLD_INLINE Mask first_lanes(std::uint32_t count) {
  return Mask::of(count < width ? (1u << count) - 1 : (1u << width) - 1);
}

BAGNOLD_INLINE Pack max(Pack a, Pack b) { return detail::larger(a.v, b.v); }

BAGNOLD_INLINE Pack positive_part(Pack a) { return detail::larger(Pack(0.0).v, a.v); }

BAGNOLD_INLINE double largest(Pack a) {
  double largest = a.v[0];
  for (int k = 1; k < width; ++k) largest = largest < a.v[k] ? a.v[k] : largest;
  return largest;
}

/// Sum of the lanes, first to last.
BAGNOLD_INLINE double sum(Pack a) {
  double sum = 0;
  for (int k = 0; k < width; ++k) sum += a.v[k];
  return sum;
}

BAGNOLD_INLINE Pack sqrt(Pack a) { return detail::root(a.v); }

BAGNOLD_INLINE Pack floor(Pack a) { return detail::rounded_down(a.v); }

/// 1/sqrt(a), to about 1 ulp.
BAGNOLD_INLINE Pack inverse_sqrt(Pack a) { return detail::inverse_root(a.v); }

using detail::EightByNumber;

/// Two counts in each lane, 1 to 8 each, as one number a + base b.
struct CountPairs {
  static constexpr int base = 64;
  detail::LargerCounts larger;

  BAGNOLD_INLINE explicit CountPairs(Pack both) : larger(both.v) {}

  /// table[n mod 8], n the larger of the two.
  BAGNOLD_INLINE Pack look_up_larger(EightByNumber const& table) const {
    return larger.look_up(table);
  }
};

/// Rows of a matrix, m[width], to its columns.
BAGNOLD_INLINE void transpose(Pack* m) {
  Lanes rows[width];
  for (int k = 0; k < width; ++k) rows[k] = m[k].v;
  detail::transpose(rows);
  for (int k = 0; k < width; ++k) m[k] = rows[k];
}

}  // namespace bagnold::simd
