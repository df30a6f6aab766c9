// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/record.hpp"

/// Eight disks in and out of packs, two numbers at a time.
#if BAGNOLD_128
namespace bagnold::simd {

namespace detail {

/// Four numbers of a disk.
struct Row {
  Two low, high;
  BAGNOLD_INLINE static Row of(double const* p) {
    Row r;
    __builtin_memcpy(&r, p, sizeof r);
    return r;
  }
  BAGNOLD_INLINE void to(double* p) const { __builtin_memcpy(p, this, sizeof *this); }
};

/// Eight rows, row(k) each, to their columns, in their order.
template <class RowOf>
BAGNOLD_INLINE Records load_rows(RowOf const& row) {
  Records s;
  auto const two = [&](int k, Two& x, Two& y, Two& z, Two& w) {
    Row const p = row(k), q = row(k + 1);
    x = firsts(p.low, q.low), y = seconds(p.low, q.low);
    z = firsts(p.high, q.high), w = seconds(p.high, q.high);
  };
  two(0, s.x.v.a, s.y.v.a, s.vx.v.a, s.vy.v.a);
  two(2, s.x.v.b, s.y.v.b, s.vx.v.b, s.vy.v.b);
  two(4, s.x.v.c, s.y.v.c, s.vx.v.c, s.vy.v.c);
  two(6, s.x.v.d, s.y.v.d, s.vx.v.d, s.vy.v.d);
  return s;
}

/// store(k, row k) of four columns.
template <class Store>
BAGNOLD_INLINE void store_rows(Pack const& x, Pack const& y, Pack const& z, Pack const& w,
                               Store const& store) {
  auto const two = [&](int k, Two x2, Two y2, Two z2, Two w2) {
    store(k, Row{firsts(x2, y2), firsts(z2, w2)});
    store(k + 1, Row{seconds(x2, y2), seconds(z2, w2)});
  };
  two(0, x.v.a, y.v.a, z.v.a, w.v.a);
  two(2, x.v.b, y.v.b, z.v.b, w.v.b);
  two(4, x.v.c, y.v.c, z.v.c, w.v.c);
  two(6, x.v.d, y.v.d, z.v.d, w.v.d);
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
  auto const rows = detail::load_rows([&](int k) {
    Two low;
    __builtin_memcpy(&low, f + k, sizeof low);
    return detail::Row{low, low};
  });
  return {rows.x, rows.y, 0.0, 0.0};
}

/// Moves `count` disks straight on: to = {x + v time, v}; `to` may be `from`.
BAGNOLD_INLINE void fly(Record* to, Record const* from, std::uint32_t count, double time) {
  Two const t{time, time};
  for (std::uint32_t i = 0; i < count; ++i) {
    auto const r = detail::Row::of(&from[i].x);
    detail::Row{detail::fused(t, r.high, r.low), r.high}.to(&to[i].x);
  }
}

BAGNOLD_INLINE Mask nonzero(std::uint8_t const* bytes) {
  unsigned lanes = 0;
  for (int k = 0; k < width; ++k) lanes |= (bytes[k] != 0 ? 1u : 0u) << k;
  return Mask::of(lanes);
}

BAGNOLD_INLINE void store_records(Record* r, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy, [&](int k, detail::Row row) { row.to(&r[k].x); });
}

BAGNOLD_INLINE void store_records(Record* r, std::uint16_t const* index4, Records const& s) {
  detail::store_rows(s.x, s.y, s.vx, s.vy,
                     [&](int k, detail::Row row) { row.to(&at(r, index4[k]).x); });
}

BAGNOLD_INLINE void scatter(Force* force, LocalPair const* pairs, Pack x, Pack y) {
  auto const add = [&](int k, Two f) {
    auto* const a = reinterpret_cast<Two*>(&at(force, pairs[k].a4));
    auto* const b = reinterpret_cast<Two*>(&at(force, pairs[k].b4));
    *a = *a + f;
    *b = *b - f;
  };
  auto const two = [&](int k, Two x2, Two y2) {
    add(k, detail::firsts(x2, y2));
    add(k + 1, detail::seconds(x2, y2));
  };
  two(0, x.v.a, y.v.a), two(2, x.v.b, y.v.b), two(4, x.v.c, y.v.c), two(6, x.v.d, y.v.d);
}

/// The torque and the count are the same for both.
BAGNOLD_INLINE void scatter(TurningForce* force, LocalPair const* pairs, Pack x, Pack y,
                            Pack torque_per_diameter, Pack count = 0.0) {
  using detail::Row;
  TwoBits const opposite{static_cast<long long>(1ULL << 63), 0};  // the sign of what is opposite
  auto const turned = [&](Two f) { return (Two)((TwoBits)f ^ opposite); };
  detail::store_rows(x, count, y, torque_per_diameter, [&](int k, Row f) {
    double* const to_a = &at(force, pairs[k].a4).x;
    double* const to_b = &at(force, pairs[k].b4).x;
    Row const a = Row::of(to_a);
    Row{a.low + f.low, a.high + f.high}.to(to_a);
    Row const b = Row::of(to_b);
    Row{b.low + turned(f.low), b.high + turned(f.high)}.to(to_b);
  });
}

/// Appends the pairs whose lane is set; writes up to eight words behind `to`.
BAGNOLD_INLINE int append(LocalPair* to, Mask mask, LocalPair const* pairs) {
  unsigned const lanes = mask.lanes();
  int count = 0;
  for (int k = 0; k < width; ++k) {
    to[count] = pairs[k];
    count += static_cast<int>(lanes >> k & 1);
  }
  return count;
}

}  // namespace bagnold::simd
#endif
