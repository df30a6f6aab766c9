// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/records_128.hpp"
#include "kernels/cpu/simd/records_avx2.hpp"
#include "kernels/cpu/simd/records_avx512.hpp"

/// Transfer of disks to and from packs: the part common to all instruction sets.
namespace bagnold::simd {

BAGNOLD_INLINE ForceComponents load_forces(Force const* f, std::uint16_t const* index4) {
  ForceComponents s;
  for (int k = 0; k < width; ++k) {
    s.x.v[k] = at(f, index4[k]).x;
    s.y.v[k] = at(f, index4[k]).y;
  }
  s.torque_per_diameter = s.count = 0.0;
  return s;
}

/// Numbers at a pack of quadrupled indices.
BAGNOLD_INLINE Pack load(double const* values, std::uint16_t const* index4) {
  Pack p;
  for (int k = 0; k < width; ++k) p.v[k] = at(values, index4[k]);
  return p;
}

BAGNOLD_INLINE void store(double* values, std::uint16_t const* index4, Pack p) {
  for (int k = 0; k < width; ++k) at(values, index4[k]) = p.v[k];
}

/// Mask of the bytes of a pack that are zero.
BAGNOLD_INLINE Mask zero(std::uint8_t const* bytes) {
  return Mask::of(~nonzero(bytes).lanes() & 0xffu);
}

struct PackPair {
  Pack x, y;
};

/// Loads a pack of contiguous vectors.
BAGNOLD_INLINE PackPair load_pairs(double const* xy) {
  auto const f = load_forces(reinterpret_cast<Force const*>(xy));
  return {f.x, f.y};
}

/// Value a plus `weight` times value b for a pack of pairs.
BAGNOLD_INLINE Pack load_sums(double const* values, LocalPair const* pairs, double weight) {
  asm("" : "+r"(pairs));  // reload the indices: cheaper than keeping sixteen
  auto const sum = [&](int k) {
    return at(values, pairs[k].a4) + weight * at(values, pairs[k].b4);
  };
  return detail::lanes_of(sum);
}

}  // namespace bagnold::simd
