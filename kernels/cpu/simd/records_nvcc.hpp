// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/record.hpp"

/// Transfer of disks to and from packs, as nvcc parses it for the device. It never runs.
#ifdef __CUDA_ARCH__
namespace bagnold::simd {

BAGNOLD_INLINE Records load_combined(Record const* records, LocalPair const* pairs,
                                     Record const& weight) {
  Records r;
  for (int k = 0; k < width; ++k) {
    Record const& a = records[pairs[k].a()];
    Record const& b = records[pairs[k].b()];
    r.x.v[k] = a.x + weight.x * b.x;
    r.y.v[k] = a.y + weight.y * b.y;
    r.vx.v[k] = a.vx + weight.vx * b.vx;
    r.vy.v[k] = a.vy + weight.vy * b.vy;
  }
  return r;
}

BAGNOLD_INLINE Records load_differences(Record const* records, LocalPair const* pairs) {
  Records r;
  for (int k = 0; k < width; ++k) {
    Record const& a = records[pairs[k].a()];
    Record const& b = records[pairs[k].b()];
    r.x.v[k] = a.x - b.x;
    r.y.v[k] = a.y - b.y;
    r.vx.v[k] = a.vx - b.vx;
    r.vy.v[k] = a.vy - b.vy;
  }
  return r;
}

namespace detail {

/// Loads a pack of records, row(k) each.
template <class Row>
BAGNOLD_INLINE Records load_rows(Row const& row) {
  Records s;
  for (int k = 0; k < width; ++k) {
    Record const& from = row(k);
    s.x.v[k] = from.x;
    s.y.v[k] = from.y;
    s.vx.v[k] = from.vx;
    s.vy.v[k] = from.vy;
  }
  return s;
}

/// Loads the forces on a pack of disks, row(k) each.
template <class Row>
BAGNOLD_INLINE ForceComponents load_turning(Row const& row) {
  ForceComponents s;
  for (int k = 0; k < width; ++k) {
    TurningForce const& from = row(k);
    s.x.v[k] = from.x;
    s.y.v[k] = from.y;
    s.torque_per_diameter.v[k] = from.torque_per_diameter;
    s.count.v[k] = from.count;
  }
  return s;
}

}  // namespace detail

BAGNOLD_INLINE Records load_records(Record const* r) {
  return detail::load_rows([&](int k) -> Record const& { return r[k]; });
}

BAGNOLD_INLINE Records load_records(Record const* r, std::uint16_t const* index4) {
  return detail::load_rows([&](int k) -> Record const& { return at(r, index4[k]); });
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f) {
  return detail::load_turning([&](int k) -> TurningForce const& { return f[k]; });
}

BAGNOLD_INLINE ForceComponents load_forces(TurningForce const* f, std::uint16_t const* index4) {
  return detail::load_turning([&](int k) -> TurningForce const& { return at(f, index4[k]); });
}

BAGNOLD_INLINE void store_records(Record* r, std::uint16_t const* index4, Records const& s) {
  for (int k = 0; k < width; ++k) at(r, index4[k]) = {s.x.v[k], s.y.v[k], s.vx.v[k], s.vy.v[k]};
}

BAGNOLD_INLINE void fly(Record* to, Record const* from, std::uint32_t count, double time) {
  for (std::uint32_t i = 0; i < count; ++i) {
    Record const r = from[i];
    to[i] = {r.x + time * r.vx, r.y + time * r.vy, r.vx, r.vy};
  }
}

BAGNOLD_INLINE ForceComponents load_forces(Force const* f) {
  ForceComponents s;
  for (int k = 0; k < width; ++k) {
    s.x.v[k] = f[k].x;
    s.y.v[k] = f[k].y;
  }
  s.torque_per_diameter = s.count = 0.0;
  return s;
}

BAGNOLD_INLINE Mask nonzero(std::uint8_t const* bytes) {
  Mask mask{};
  for (int k = 0; k < width; ++k) mask.bits[k] = bytes[k] != 0 ? -1 : 0;
  return mask;
}

BAGNOLD_INLINE void store_records(Record* r, Records const& s) {
  for (int k = 0; k < width; ++k) r[k] = {s.x.v[k], s.y.v[k], s.vx.v[k], s.vy.v[k]};
}

BAGNOLD_INLINE void scatter(Force* force, LocalPair const* pairs, Pack x, Pack y) {
  for (int k = 0; k < width; ++k) {
    Force& a = force[pairs[k].a()];
    a = {a.x + x.v[k], a.y + y.v[k]};
    Force& b = force[pairs[k].b()];
    b = {b.x - x.v[k], b.y - y.v[k]};
  }
}

BAGNOLD_INLINE void scatter(TurningForce* force, LocalPair const* pairs, Pack x, Pack y,
                            Pack torque_per_diameter, Pack count = 0.0) {
  for (int k = 0; k < width; ++k) {
    TurningForce& a = force[pairs[k].a()];
    a = {a.x + x.v[k], a.count + count.v[k], a.y + y.v[k],
         a.torque_per_diameter + torque_per_diameter.v[k]};
    TurningForce& b = force[pairs[k].b()];
    b = {b.x - x.v[k], b.count + count.v[k], b.y - y.v[k],
         b.torque_per_diameter + torque_per_diameter.v[k]};
  }
}

BAGNOLD_INLINE int append(LocalPair* to, Mask mask, LocalPair const* pairs) {
  int count = 0;
  for (unsigned lanes = mask.lanes(), k = 0; k < width; ++k)
    if (lanes >> k & 1) to[count++] = pairs[k];
  return count;
}

}  // namespace bagnold::simd
#endif
