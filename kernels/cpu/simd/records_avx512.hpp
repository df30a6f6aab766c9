// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/record.hpp"

/// Transfer of eight disks to and from packs, with AVX-512.
#if BAGNOLD_AVX512
namespace bagnold::simd {

namespace detail {

BAGNOLD_INLINE __m512d join(__m256d low, __m256d high) {
  return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
}

/// Rows 0 2 | 1 3 | 4 6 | 5 7 of an 8 x 4 matrix to its columns.
BAGNOLD_INLINE Records transpose(__m512d z02, __m512d z13, __m512d z46, __m512d z57) {
  __m512d const low0 = _mm512_unpacklo_pd(z02, z13), high0 = _mm512_unpackhi_pd(z02, z13);
  __m512d const low4 = _mm512_unpacklo_pd(z46, z57), high4 = _mm512_unpackhi_pd(z46, z57);
  return {(Lanes)_mm512_shuffle_f64x2(low0, low4, 0x88),
          (Lanes)_mm512_shuffle_f64x2(high0, high4, 0x88),
          (Lanes)_mm512_shuffle_f64x2(low0, low4, 0xdd),
          (Lanes)_mm512_shuffle_f64x2(high0, high4, 0xdd)};
}

BAGNOLD_INLINE __m256d load(Record const& r) { return _mm256_load_pd(&r.x); }

/// Loads eight rows of four numbers, row(k) each.
template <class Row>
BAGNOLD_INLINE Records load_rows(Row const& row) {
  return transpose(join(row(0), row(2)), join(row(1), row(3)), join(row(4), row(6)),
                   join(row(5), row(7)));
}
BAGNOLD_INLINE Records load_rows(double const* r) {
  return load_rows([&](int k) { return _mm256_load_pd(r + 4 * k); });
}

}  // namespace detail

/// Record a minus record b of eight pairs.
BAGNOLD_INLINE Records load_differences(Record const* records, LocalPair const* pairs) {
  auto const difference = [&](int k) {
    return _mm256_sub_pd(detail::load(at(records, pairs[k].a4)),
                         detail::load(at(records, pairs[k].b4)));
  };
  __m256d const d0 = difference(0), d1 = difference(1), d2 = difference(2), d3 = difference(3);
  __m256d const d4 = difference(4), d5 = difference(5), d6 = difference(6), d7 = difference(7);
  return detail::transpose(detail::join(d0, d2), detail::join(d1, d3), detail::join(d4, d6),
                           detail::join(d5, d7));
}

/// Record a plus `weight` times record b of eight pairs, component by component.
BAGNOLD_INLINE Records load_combined(Record const* records, LocalPair const* pairs,
                                     Record const& weight) {
  __m256d const w = detail::load(weight);
  return detail::load_rows([&](int k) {
    return _mm256_fmadd_pd(w, detail::load(at(records, pairs[k].b4)),
                           detail::load(at(records, pairs[k].a4)));
  });
}

/// Records at eight quadrupled indices.
BAGNOLD_INLINE Records load_records(Record const* r, std::uint16_t const* index4) {
  return detail::load_rows([&](int k) { return detail::load(at(r, index4[k])); });
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f, std::uint16_t const* index4) {
  auto const rows = detail::load_rows([&](int k) { return _mm256_load_pd(&at(f, index4[k]).x); });
  return {rows.x, rows.vx, rows.vy, rows.y};
}

/// Moves `count` (even) disks on straight lines: to = {x + v time, v}; `to` may be `from`.
BAGNOLD_INLINE void fly(Record* to, Record const* from, std::uint32_t count, double time) {
  __m512d const t = _mm512_set1_pd(time);
  for (std::uint32_t i = 0; i < count; i += 2) {
    __m512d const r = _mm512_loadu_pd(&from[i].x);
    _mm512_storeu_pd(&to[i].x, _mm512_mask3_fmadd_pd(t, _mm512_permutex_pd(r, 0xee), r, 0x33));
  }
}

/// Eight records in a row.
BAGNOLD_INLINE Records load_records(Record const* r) { return detail::load_rows(&r->x); }

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f) {
  auto const rows = detail::load_rows(&f->x);
  return {rows.x, rows.vx, rows.vy, rows.y};
}

BAGNOLD_INLINE ForceComponents load_forces(Force const* f) {
  Pack const a = Pack::load(&f->x), b = Pack::load(&f->x + width);
  __m512i const even = _mm512_setr_epi64(0, 2, 4, 6, 8, 10, 12, 14);
  __m512i const odd = _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15);
  return {(Lanes)_mm512_permutex2var_pd((__m512d)a.v, even, (__m512d)b.v),
          (Lanes)_mm512_permutex2var_pd((__m512d)a.v, odd, (__m512d)b.v), 0.0, 0.0};
}

/// Mask of the bytes, of eight, that are not zero.
BAGNOLD_INLINE Mask nonzero(std::uint8_t const* bytes) {
  __m128i const b = _mm_loadl_epi64(reinterpret_cast<__m128i const*>(bytes));
  return {static_cast<__mmask8>(
      _mm512_test_epi64_mask(_mm512_cvtepu8_epi64(b), _mm512_set1_epi64(-1)))};
}

namespace detail {

/// Calls store(k, row k) for eight records.
template <class Store>
BAGNOLD_INLINE void store_rows(Records const& s, Store const& store) {
  __m512d const xy0 = _mm512_unpacklo_pd((__m512d)s.x.v, (__m512d)s.y.v);  // x0 y0 x2 y2 ..
  __m512d const xy1 = _mm512_unpackhi_pd((__m512d)s.x.v, (__m512d)s.y.v);  // x1 y1 x3 y3 ..
  __m512d const v0 = _mm512_unpacklo_pd((__m512d)s.vx.v, (__m512d)s.vy.v);
  __m512d const v1 = _mm512_unpackhi_pd((__m512d)s.vx.v, (__m512d)s.vy.v);
  __m512i const low = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
  __m512i const high = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  __m512d const r02 = _mm512_permutex2var_pd(xy0, low, v0),
                r46 = _mm512_permutex2var_pd(xy0, high, v0);
  __m512d const r13 = _mm512_permutex2var_pd(xy1, low, v1),
                r57 = _mm512_permutex2var_pd(xy1, high, v1);
  store(0, _mm512_castpd512_pd256(r02));
  store(1, _mm512_castpd512_pd256(r13));
  store(2, _mm512_extractf64x4_pd(r02, 1));
  store(3, _mm512_extractf64x4_pd(r13, 1));
  store(4, _mm512_castpd512_pd256(r46));
  store(5, _mm512_castpd512_pd256(r57));
  store(6, _mm512_extractf64x4_pd(r46, 1));
  store(7, _mm512_extractf64x4_pd(r57, 1));
}

}  // namespace detail

BAGNOLD_INLINE void store_records(Record* r, Records const& s) {
  detail::store_rows(s, [&](int k, __m256d v) { _mm256_store_pd(&r[k].x, v); });
}

BAGNOLD_INLINE void store_records(Record* r, std::uint16_t const* index4, Records const& s) {
  detail::store_rows(s, [&](int k, __m256d v) { _mm256_store_pd(&at(r, index4[k]).x, v); });
}

/// Adds the force on a of eight pairs, and its opposite on b, one pair after the other.
BAGNOLD_INLINE void scatter(Force* force, LocalPair const* pairs, Pack x, Pack y) {
  __m512d const even = _mm512_unpacklo_pd((__m512d)x.v, (__m512d)y.v);
  __m512d const odd = _mm512_unpackhi_pd((__m512d)x.v, (__m512d)y.v);
  auto const add = [&](int k, __m128d f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    _mm_store_pd(a, _mm_add_pd(_mm_load_pd(a), f));
    _mm_store_pd(b, _mm_sub_pd(_mm_load_pd(b), f));
  };
  add(0, _mm512_castpd512_pd128(even));
  add(1, _mm512_castpd512_pd128(odd));
  add(2, _mm512_extractf64x2_pd(even, 1));
  add(3, _mm512_extractf64x2_pd(odd, 1));
  add(4, _mm512_extractf64x2_pd(even, 2));
  add(5, _mm512_extractf64x2_pd(odd, 2));
  add(6, _mm512_extractf64x2_pd(even, 3));
  add(7, _mm512_extractf64x2_pd(odd, 3));
}

/// Adds forces to a and their opposites to b. The torque over the diameter and the count are equal
/// for both.
BAGNOLD_INLINE void scatter(TurningForce* force, LocalPair const* pairs, Pack x, Pack y,
                            Pack torque_per_diameter, Pack count = 0.0) {
  __m512d const x0 = _mm512_unpacklo_pd((__m512d)x.v, (__m512d)count.v);
  __m512d const x1 = _mm512_unpackhi_pd((__m512d)x.v, (__m512d)count.v);
  __m512d const y0 = _mm512_unpacklo_pd((__m512d)y.v, (__m512d)torque_per_diameter.v);
  __m512d const y1 = _mm512_unpackhi_pd((__m512d)y.v, (__m512d)torque_per_diameter.v);
  __m512i const low = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
  __m512i const high = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  __m512d const f02 = _mm512_permutex2var_pd(x0, low, y0),
                f46 = _mm512_permutex2var_pd(x0, high, y0);
  __m512d const f13 = _mm512_permutex2var_pd(x1, low, y1),
                f57 = _mm512_permutex2var_pd(x1, high, y1);
  auto const add = [&](int k, __m256d f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    _mm256_store_pd(a, _mm256_add_pd(_mm256_load_pd(a), f));
    _mm256_store_pd(b, _mm256_addsub_pd(_mm256_load_pd(b), f));
  };
  add(0, _mm512_castpd512_pd256(f02));
  add(1, _mm512_castpd512_pd256(f13));
  add(2, _mm512_extractf64x4_pd(f02, 1));
  add(3, _mm512_extractf64x4_pd(f13, 1));
  add(4, _mm512_castpd512_pd256(f46));
  add(5, _mm512_castpd512_pd256(f57));
  add(6, _mm512_extractf64x4_pd(f46, 1));
  add(7, _mm512_extractf64x4_pd(f57, 1));
}

/// Appends the pairs whose lane is set; writes up to eight words beyond `to`.
BAGNOLD_INLINE int append(LocalPair* to, Mask mask, LocalPair const* pairs) {
  __m256i const words = _mm256_loadu_si256(reinterpret_cast<__m256i const*>(pairs));
  auto const packed = _mm512_maskz_compress_epi32(mask.bits, _mm512_castsi256_si512(words));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm512_castsi512_si256(packed));
  return __builtin_popcount(mask.bits);
}

}  // namespace bagnold::simd
#endif
