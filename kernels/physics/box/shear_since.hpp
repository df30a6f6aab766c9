// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/double_double.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// How far the images of the box have come some steps after a list build.
struct ShearSince {
  DoubleDouble turns;        ///< gamma L_y/L_x at the build, in [0, 1)
  DoubleDouble step_strain;  ///< gammadot dt
  Real length;               ///< L_x, [d_s]
  Real aspect;               ///< L_y / L_x

  KOKKOS_FUNCTION Real strain(std::int64_t steps) const {
    return (step_strain * static_cast<double>(steps)).rounded();
  }

  /// x of the image above, [d_s]; in [0, L_x) at the build, from where it grows on.
  KOKKOS_FUNCTION Real offset(std::int64_t steps) const {
    return ((turns + step_strain * aspect * static_cast<double>(steps)) * length).rounded();
  }
};

/// turns: of any size; taken as none where they would round up to a whole one.
KOKKOS_INLINE_FUNCTION ShearSince shear_since(DoubleDouble const& turns,
                                              DoubleDouble const& step_strain, Real length,
                                              Real aspect) {
  ShearSince since{fraction(turns), step_strain, length, aspect};
  if (since.offset(0) >= length) since.turns = {};
  return since;
}

}  // namespace bagnold
