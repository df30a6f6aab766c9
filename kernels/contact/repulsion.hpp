// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/contact/contact.hpp"
#include "kernels/core/kokkos_compat.hpp"

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
    return c.relative_overlap / c.contact_distance;
  }
};

/// The same with alpha = 5/2, Hertz.
struct HertzianRepulsion {
  static constexpr double force_exponent = 2.5;

  template <class T>
  KOKKOS_FUNCTION T magnitude(Contact<T> const& c) const {
    return c.relative_overlap * math::sqrt(c.relative_overlap) / c.contact_distance;
  }
};

}  // namespace bagnold
