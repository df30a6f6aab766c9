// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Relative motion of two disks that touch no other, one component: along the normal, or the
/// sliding of their points of contact.
struct RelativeMotion {
  Real x;  ///< distance beyond contact, [d_s]; negative: overlap
  Real v;  ///< [d_s / tau_e]
};

/// Contact of two disks that touch no other, per reduced mass: x'' = -k x - c x'.
struct LoneContact {
  Real stiffness;      ///< k, [1 / tau_e^2]
  Real damping;        ///< c, [1 / tau_e]
  bool opens = false;  ///< acts where x < 0 only, as disks that meet; else as if held together

  bool acts(RelativeMotion const& q) const { return !opens || q.x < 0; }

  Real acceleration(RelativeMotion const& q) const {
    return acts(q) ? -stiffness * q.x - damping * q.v : Real(0);
  }
};

/// One step of a scheme on (x, v), columns from the unit vectors: a contact that is linear and does
/// not open. Scheme: as in schemes.hpp.
struct ContactMatrix {
  Real xx, xv, vx, vv;

  template <class Scheme>
  static ContactMatrix of(Scheme, LoneContact const& contact, Real time_step) {
    RelativeMotion const x = Scheme::step({1, 0}, contact, time_step);
    RelativeMotion const v = Scheme::step({0, 1}, contact, time_step);
    return {x.x, v.x, x.v, v.v};
  }

  /// Largest |eigenvalue|: above 1 the step makes energy.
  Real radius() const {
    Real const half_trace = (xx + vv) / 2;
    Real const determinant = xx * vv - xv * vx;
    Real const discriminant = half_trace * half_trace - determinant;
    if (discriminant < 0) return std::sqrt(determinant);
    return std::abs(half_trace) + std::sqrt(discriminant);
  }
};

}  // namespace bagnold
