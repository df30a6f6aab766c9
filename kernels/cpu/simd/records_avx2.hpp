// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kernels/cpu/simd/record.hpp"

/// Transfer of four disks to and from packs, with AVX2.
#if BAGNOLD_AVX2
namespace bagnold::simd {

namespace detail {

BAGNOLD_INLINE __m256d load(Record const& r) { return _mm256_load_pd(&r.x); }

/// Loads four rows of four numbers, row(k) each, into columns.
template <class Row>
BAGNOLD_INLINE Records load_rows(Row const& row) {
  __m256d a = row(0), b = row(1), c = row(2), d = row(3);
  transpose(a, b, c, d);
  return {(Lanes)a, (Lanes)b, (Lanes)c, (Lanes)d};
}
BAGNOLD_INLINE Records load_rows(double const* r) {
  return load_rows([&](int k) { return _mm256_load_pd(r + 4 * k); });
}

/// Calls store(k, row k) for four columns.
template <class Store>
BAGNOLD_INLINE void store_rows(Pack x, Pack y, Pack z, Pack w, Store const& store) {
  __m256d a = (__m256d)x.v, b = (__m256d)y.v, c = (__m256d)z.v, d = (__m256d)w.v;
  transpose(a, b, c, d);
  store(0, a), store(1, b), store(2, c), store(3, d);
}

/// Permutation, for each set of lanes, that moves these lanes to the front.
inline constexpr auto packed_places = [] {
  struct Places {
    std::int32_t at[width];
  };
  std::array<Places, 1 << width> places{};
  for (int lanes = 0; lanes < 1 << width; ++lanes)
    for (int k = 0, to = 0; k < width; ++k)
      if (lanes >> k & 1) places[lanes].at[to++] = k;
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
  __m256d const a = _mm256_loadu_pd(&f[0].x), b = _mm256_loadu_pd(&f[2].x);
  auto const in_order = [](__m256d mixed) {  // 0 2 1 3
    return (Lanes)_mm256_permute4x64_pd(mixed, 0xd8);
  };
  return {in_order(_mm256_unpacklo_pd(a, b)), in_order(_mm256_unpackhi_pd(a, b)), 0.0, 0.0};
}

/// Moves `count` disks on straight lines: to = {x + v time, v}; `to` may be `from`.
BAGNOLD_INLINE void fly(Record* to, Record const* from, std::uint32_t count, double time) {
  __m256d const t = _mm256_set1_pd(time);
  for (std::uint32_t i = 0; i < count; ++i) {
    __m256d const r = detail::load(from[i]);
    __m256d const moved = _mm256_fmadd_pd(t, _mm256_permute4x64_pd(r, 0xee), r);
    _mm256_store_pd(&to[i].x, _mm256_blend_pd(r, moved, 0x3));
  }
}

BAGNOLD_INLINE Mask nonzero(std::uint8_t const* bytes) {
  std::int32_t word;
  __builtin_memcpy(&word, bytes, sizeof word);
  __m256i const wide = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(word));
  return {_mm256_castsi256_pd(_mm256_cmpgt_epi64(wide, _mm256_setzero_si256()))};
}

BAGNOLD_INLINE void store_records(Record* r, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy, [&](int k, __m256d v) { _mm256_store_pd(&r[k].x, v); });
}

BAGNOLD_INLINE void store_records(Record* r, std::uint16_t const* index4, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy,
                     [&](int k, __m256d v) { _mm256_store_pd(&at(r, index4[k]).x, v); });
}

BAGNOLD_INLINE void scatter(Force* force, LocalPair const* pairs, Pack x, Pack y) {
  __m256d const even = _mm256_unpacklo_pd((__m256d)x.v, (__m256d)y.v);
  __m256d const odd = _mm256_unpackhi_pd((__m256d)x.v, (__m256d)y.v);
  auto const add = [&](int k, __m128d f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    _mm_store_pd(a, _mm_add_pd(_mm_load_pd(a), f));
    _mm_store_pd(b, _mm_sub_pd(_mm_load_pd(b), f));
  };
  add(0, _mm256_castpd256_pd128(even));
  add(1, _mm256_castpd256_pd128(odd));
  add(2, _mm256_extractf128_pd(even, 1));
  add(3, _mm256_extractf128_pd(odd, 1));
}

/// Adds forces to a and their opposites to b. The torque over the diameter and the count are equal
/// for both.
BAGNOLD_INLINE void scatter(TurningForce* force, LocalPair const* pairs, Pack x, Pack y,
                            Pack torque_per_diameter, Pack count = 0.0) {
  detail::store_rows(x, count, y, torque_per_diameter, [&](int k, __m256d f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    _mm256_store_pd(a, _mm256_add_pd(_mm256_load_pd(a), f));
    _mm256_store_pd(b, _mm256_addsub_pd(_mm256_load_pd(b), f));
  });
}

/// Appends the pairs whose lane is set; writes up to a pack of words beyond `to`.
BAGNOLD_INLINE int append(LocalPair* to, Mask mask, LocalPair const* pairs) {
  unsigned const lanes = mask.lanes();
  auto const* const places = reinterpret_cast<__m128i const*>(detail::packed_places[lanes].at);
  __m128 const words = _mm_loadu_ps(reinterpret_cast<float const*>(pairs));
  _mm_storeu_ps(reinterpret_cast<float*>(to), _mm_permutevar_ps(words, _mm_loadu_si128(places)));
  return __builtin_popcount(lanes);
}

}  // namespace bagnold::simd
#endif
