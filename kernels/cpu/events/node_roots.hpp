// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/closed_form/node_numbers.hpp"

namespace bagnold {

#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuninitialized"  // of g++ 12, in its own header of AVX-512
#endif

/// 1/sqrt at each node: formulas of pairs find it by its name.
inline AtNodes inverse_sqrt(AtNodes const& a) {
  static_assert(AtNodes::count % simd::width == 0);
  alignas(64) double lanes[AtNodes::count];
  __builtin_memcpy(lanes, &a.v, sizeof lanes);
  for (int k = 0; k < AtNodes::count; k += simd::width)
    (simd::Pack(1.0) / simd::sqrt(simd::Pack::load(lanes + k))).store(lanes + k);
  AtNodes root;
  __builtin_memcpy(&root.v, lanes, sizeof lanes);
  return root;
}

#pragma GCC diagnostic pop

}  // namespace bagnold
