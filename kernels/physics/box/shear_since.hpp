// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/double_double.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Step from which strain and offset are counted: that of a list build.
struct ShearMark {
  std::int64_t step = 0;
  DoubleDouble strain{};  ///< since step 0
  DoubleDouble turns{};   ///< gamma L_y/L_x, in [0, 1)
};

/// Displacement of the images of the box since a mark, from some step on at a constant rate.
struct ShearSince {
  DoubleDouble turns;        ///< gamma L_y/L_x at the mark, in [0, 1)
  DoubleDouble before;       ///< strain from the mark to `first`
  std::int64_t first;        ///< step from which the rate is this one, or the mark's
  DoubleDouble step_strain;  ///< gammadot dt
  Real length;               ///< L_x, [d_s]
  Real aspect;               ///< L_y / L_x

  /// step: from `first` on.
  KOKKOS_FUNCTION Real strain(std::int64_t step) const {
    return (before + step_strain * static_cast<double>(step - first)).rounded();
  }

  /// x of the image above, [d_s]; in [0, L_x) at the mark, growing from there.
  KOKKOS_FUNCTION Real offset(std::int64_t step) const {
    return ((turns + before * aspect + step_strain * aspect * static_cast<double>(step - first)) *
            length)
        .rounded();
  }
};

/// Fraction of `turns` in [0, 1). turns: any number; zero where the fraction times `length` rounds
/// up to `length`.
KOKKOS_INLINE_FUNCTION DoubleDouble turns_in_box(DoubleDouble const& turns, Real length) {
  DoubleDouble const part = fraction(turns);
  return (part * length).rounded() >= length ? DoubleDouble{} : part;
}

}  // namespace bagnold
