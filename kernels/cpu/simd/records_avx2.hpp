// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kernels/cpu/simd/record.hpp"

/// Eight disks in and out of packs, with AVX2.
#if BAGNOLD_AVX2
namespace bagnold::simd {

namespace detail {

BAGNOLD_INLINE __m256d load(Record const& r) { return _mm256_load_pd(&r.x); }

/// Eight rows of four numbers, row(k) each, to their columns.
template <class Row>
BAGNOLD_INLINE Records load_rows(Row const& row) {
  __m256d a = row(0), b = row(1), c = row(2), d = row(3);
  transpose(a, b, c, d);
  __m256d e = row(4), f = row(5), g = row(6), h = row(7);
  transpose(e, f, g, h);
  return {Lanes(a, e), Lanes(b, f), Lanes(c, g), Lanes(d, h)};
}
BAGNOLD_INLINE Records load_rows(double const* r) {
  return load_rows([&](int k) { return _mm256_load_pd(r + 4 * k); });
}

/// store(k, row k) of four columns.
template <class Store>
BAGNOLD_INLINE void store_rows(Pack const& x, Pack const& y, Pack const& z, Pack const& w,
                               Store const& store) {
  __m256d a = x.v.low, b = y.v.low, c = z.v.low, d = w.v.low;
  transpose(a, b, c, d);
  store(0, a), store(1, b), store(2, c), store(3, d);
  __m256d e = x.v.high, f = y.v.high, g = z.v.high, h = w.v.high;
  transpose(e, f, g, h);
  store(4, e), store(5, f), store(6, g), store(7, h);
}

/// For each set of lanes where they go to stand side by side, a byte each.
inline constexpr auto packed_places = [] {
  std::array<std::uint64_t, 256> places{};
  for (unsigned lanes = 0; lanes < 256; ++lanes) {
    int to = 0;
    for (unsigned k = 0; k < 8; ++k)
      if (lanes >> k & 1) places[lanes] |= std::uint64_t{k} << 8 * to++;
  }
  return places;
}();

}  // namespace detail

BAGNOLD_INLINE Records load_differences(Record const* records, LocalPair const* pairs) {
  return detail::load_rows([&](int k) {
    return _mm256_sub_pd(detail::load(at(records, pairs[k].a4)),
                         detail::load(at(records, pairs[k].b4)));
  });
}

BAGNOLD_INLINE Records load_combined(Record const* records, LocalPair const* pairs,
                                     Record const& weight) {
  __m256d const w = detail::load(weight);
  return detail::load_rows([&](int k) {
    return _mm256_fmadd_pd(w, detail::load(at(records, pairs[k].b4)),
                           detail::load(at(records, pairs[k].a4)));
  });
}

BAGNOLD_INLINE Records load_records(Record const* r) { return detail::load_rows(&r->x); }

BAGNOLD_INLINE Records load_records(Record const* r, std::uint16_t const* index4) {
  return detail::load_rows([&](int k) { return detail::load(at(r, index4[k])); });
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f) {
  auto const rows = detail::load_rows(&f->x);
  return {rows.x, rows.vx, rows.vy, rows.y};
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f, std::uint16_t const* index4) {
  auto const rows = detail::load_rows([&](int k) { return _mm256_load_pd(&at(f, index4[k]).x); });
  return {rows.x, rows.vx, rows.vy, rows.y};
}

BAGNOLD_INLINE ForceComponents load_forces(Force const* f) {
  auto const part = [&](int first, bool odd) {  // x0 y0 x1 y1, x2 y2 x3 y3 to one of both
    __m256d const a = _mm256_loadu_pd(&f[first].x), b = _mm256_loadu_pd(&f[first + 2].x);
    __m256d const mixed = odd ? _mm256_unpackhi_pd(a, b) : _mm256_unpacklo_pd(a, b);
    return _mm256_permute4x64_pd(mixed, 0xd8);
  };
  return {Lanes(part(0, false), part(4, false)), Lanes(part(0, true), part(4, true)), 0.0, 0.0};
}

/// Moves `count` disks straight on: to = {x + v time, v}; `to` may be `from`.
BAGNOLD_INLINE void fly(Record* to, Record const* from, std::uint32_t count, double time) {
  __m256d const t = _mm256_set1_pd(time);
  for (std::uint32_t i = 0; i < count; ++i) {
    __m256d const r = detail::load(from[i]);
    __m256d const moved = _mm256_fmadd_pd(t, _mm256_permute4x64_pd(r, 0xee), r);
    _mm256_store_pd(&to[i].x, _mm256_blend_pd(r, moved, 0x3));
  }
}

BAGNOLD_INLINE Mask nonzero(std::uint8_t const* bytes) {
  auto const four = [](std::uint8_t const* b) {
    std::int32_t word;
    __builtin_memcpy(&word, b, sizeof word);
    __m256i const wide = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(word));
    return _mm256_castsi256_pd(_mm256_cmpgt_epi64(wide, _mm256_setzero_si256()));
  };
  return {four(bytes), four(bytes + 4)};
}

BAGNOLD_INLINE void store_records(Record* r, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy, [&](int k, __m256d v) { _mm256_store_pd(&r[k].x, v); });
}

BAGNOLD_INLINE void store_records(Record* r, std::uint16_t const* index4, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy,
                     [&](int k, __m256d v) { _mm256_store_pd(&at(r, index4[k]).x, v); });
}

BAGNOLD_INLINE void scatter(Force* force, LocalPair const* pairs, Pack x, Pack y) {
  auto const add = [&](int k, __m128d f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    _mm_store_pd(a, _mm_add_pd(_mm_load_pd(a), f));
    _mm_store_pd(b, _mm_sub_pd(_mm_load_pd(b), f));
  };
  auto const four = [&](int first, __m256d x4, __m256d y4) {
    __m256d const even = _mm256_unpacklo_pd(x4, y4), odd = _mm256_unpackhi_pd(x4, y4);
    add(first, _mm256_castpd256_pd128(even));
    add(first + 1, _mm256_castpd256_pd128(odd));
    add(first + 2, _mm256_extractf128_pd(even, 1));
    add(first + 3, _mm256_extractf128_pd(odd, 1));
  };
  four(0, x.v.low, y.v.low);
  four(4, x.v.high, y.v.high);
}

/// The torque and the count are the same for both.
BAGNOLD_INLINE void scatter(TurningForce* force, LocalPair const* pairs, Pack x, Pack y,
                            Pack torque_per_diameter, Pack count = 0.0) {
  detail::store_rows(x, count, y, torque_per_diameter, [&](int k, __m256d f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    _mm256_store_pd(a, _mm256_add_pd(_mm256_load_pd(a), f));
    _mm256_store_pd(b, _mm256_addsub_pd(_mm256_load_pd(b), f));
  });
}

/// Appends the pairs whose lane is set; writes up to eight words behind `to`.
BAGNOLD_INLINE int append(LocalPair* to, Mask mask, LocalPair const* pairs) {
  unsigned const lanes = mask.lanes();
  __m256i const places =
      _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(detail::packed_places[lanes])));
  __m256i const words = _mm256_loadu_si256(reinterpret_cast<__m256i const*>(pairs));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(words, places));
  return __builtin_popcount(lanes);
}

}  // namespace bagnold::simd
#endif
