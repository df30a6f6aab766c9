// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/math.hpp"

namespace bagnold {

/// Elastic repulsion along the normal, on i away from j, [m d_s / tau_e^2].
///
///     f_el = (k_e / d_ij) (1 - r_ij / d_ij)^(alpha - 1)     P1 Eq. (2), P2 Eq. (2), with k_e = 1
///
/// alpha = 2, the papers' value.
struct HarmonicRepulsion {
  static constexpr double force_exponent = 2.0;

  template <class T>
  KOKKOS_FUNCTION T magnitude(Contact<T> const& c) const {
    return c.relative_overlap * c.inverse_distance;
  }
};

/// The same with alpha = 5/2, Hertz.
struct HertzianRepulsion {
  static constexpr double force_exponent = 2.5;

  template <class T>
  KOKKOS_FUNCTION T magnitude(Contact<T> const& c) const {
    using math::positive_part;  // packs bring their own
    using math::sqrt;
    T const overlap = positive_part(c.relative_overlap);  // rounding may leave -1e-16 at a touch
    return overlap * sqrt(overlap) * c.inverse_distance;
  }
};

}  // namespace bagnold
