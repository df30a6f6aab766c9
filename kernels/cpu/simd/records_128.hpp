// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/record.hpp"

/// Transfer of two disks to and from packs, two numbers at a time.
#if BAGNOLD_128
namespace bagnold::simd {

namespace detail {

BAGNOLD_INLINE Lanes two(double const* p) {
  Lanes v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
BAGNOLD_INLINE void put(Lanes v, double* p) { __builtin_memcpy(p, &v, sizeof v); }

/// Four numbers of a disk.
struct Row {
  Lanes low, high;
  BAGNOLD_INLINE static Row of(double const* p) { return {two(p), two(p + 2)}; }
  BAGNOLD_INLINE void to(double* p) const { put(low, p), put(high, p + 2); }
};

/// Loads two rows, row(k) each, into columns, in their order.
template <class RowOf>
BAGNOLD_INLINE Records load_rows(RowOf const& row) {
  Row const p = row(0), q = row(1);
  return {firsts(p.low, q.low), seconds(p.low, q.low), firsts(p.high, q.high),
          seconds(p.high, q.high)};
}

/// Calls store(k, row k) for four columns.
template <class Store>
BAGNOLD_INLINE void store_rows(Pack x, Pack y, Pack z, Pack w, Store const& store) {
  store(0, Row{firsts(x.v, y.v), firsts(z.v, w.v)});
  store(1, Row{seconds(x.v, y.v), seconds(z.v, w.v)});
}

}  // namespace detail

BAGNOLD_INLINE Records load_differences(Record const* records, LocalPair const* pairs) {
  using detail::Row;
  return detail::load_rows([&](int k) {
    Row const a = Row::of(&at(records, pairs[k].a4).x), b = Row::of(&at(records, pairs[k].b4).x);
    return Row{a.low - b.low, a.high - b.high};
  });
}

BAGNOLD_INLINE Records load_combined(Record const* records, LocalPair const* pairs,
                                     Record const& weight) {
  using detail::Row;
  Row const w = Row::of(&weight.x);
  return detail::load_rows([&](int k) {
    Row const a = Row::of(&at(records, pairs[k].a4).x), b = Row::of(&at(records, pairs[k].b4).x);
    return Row{detail::fused(w.low, b.low, a.low), detail::fused(w.high, b.high, a.high)};
  });
}

BAGNOLD_INLINE Records load_records(Record const* r) {
  return detail::load_rows([&](int k) { return detail::Row::of(&r[k].x); });
}

BAGNOLD_INLINE Records load_records(Record const* r, std::uint16_t const* index4) {
  return detail::load_rows([&](int k) { return detail::Row::of(&at(r, index4[k]).x); });
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f) {
  auto const rows = detail::load_rows([&](int k) { return detail::Row::of(&f[k].x); });
  return {rows.x, rows.vx, rows.vy, rows.y};
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f, std::uint16_t const* index4) {
  auto const rows = detail::load_rows([&](int k) { return detail::Row::of(&at(f, index4[k]).x); });
  return {rows.x, rows.vx, rows.vy, rows.y};
}

BAGNOLD_INLINE ForceComponents load_forces(Force const* f) {
  Lanes const a = detail::two(&f[0].x), b = detail::two(&f[1].x);
  return {detail::firsts(a, b), detail::seconds(a, b), 0.0, 0.0};
}

/// Moves `count` disks on straight lines: to = {x + v time, v}; `to` may be `from`.
BAGNOLD_INLINE void fly(Record* to, Record const* from, std::uint32_t count, double time) {
  Lanes const t{time, time};
  for (std::uint32_t i = 0; i < count; ++i) {
    auto const r = detail::Row::of(&from[i].x);
    detail::Row{detail::fused(t, r.high, r.low), r.high}.to(&to[i].x);
  }
}

BAGNOLD_INLINE Mask nonzero(std::uint8_t const* bytes) {
  return Mask::of((bytes[0] != 0 ? 1u : 0u) | (bytes[1] != 0 ? 2u : 0u));
}

BAGNOLD_INLINE void store_records(Record* r, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy, [&](int k, detail::Row row) { row.to(&r[k].x); });
}

BAGNOLD_INLINE void store_records(Record* r, std::uint16_t const* index4, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy,
                     [&](int k, detail::Row row) { row.to(&at(r, index4[k]).x); });
}

BAGNOLD_INLINE void scatter(Force* force, LocalPair const* pairs, Pack x, Pack y) {
  auto const add = [&](int k, Lanes f) {
    double* const a = &at(force, pairs[k].a4).x;
    double* const b = &at(force, pairs[k].b4).x;
    detail::put(detail::two(a) + f, a);
    detail::put(detail::two(b) - f, b);
  };
  add(0, detail::firsts(x.v, y.v));
  add(1, detail::seconds(x.v, y.v));
}

/// Adds forces to a and their opposites to b. The torque over the diameter and the count are equal
/// for both.
BAGNOLD_INLINE void scatter(TurningForce* force, LocalPair const* pairs, Pack x, Pack y,
                            Pack torque_per_diameter, Pack count = 0.0) {
  using detail::Row;
  Mask::Bits const opposite{static_cast<long long>(1ULL << 63), 0};  // the sign of what is opposite
  auto const turned = [&](Lanes f) { return (Lanes)((Mask::Bits)f ^ opposite); };
  detail::store_rows(x, count, y, torque_per_diameter, [&](int k, Row f) {
    double* const to_a = &at(force, pairs[k].a4).x;
    double* const to_b = &at(force, pairs[k].b4).x;
    Row const a = Row::of(to_a);
    Row{a.low + f.low, a.high + f.high}.to(to_a);
    Row const b = Row::of(to_b);
    Row{b.low + turned(f.low), b.high + turned(f.high)}.to(to_b);
  });
}

/// Appends the pairs whose lane is set; writes up to a pack of words beyond `to`.
BAGNOLD_INLINE int append(LocalPair* to, Mask mask, LocalPair const* pairs) {
  unsigned const lanes = mask.lanes();
  LocalPair const first = pairs[0], second = pairs[1];
  to[0] = lanes & 1 ? first : second;
  to[1] = second;
  return __builtin_popcount(lanes);
}

}  // namespace bagnold::simd
#endif
