// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/laws/dense_flow.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Separate damping along the normal and the tangent, at the point of contact.
///
///     f_dis = -k_n (v^C . n) n - k_t [v^C - (v^C . n) n]     PRE 95, 052903 (2017), end of Sec. II
///     B
///
/// Force on i from j, [m d_s / tau_e^2]. k_t = 0 is CD_n, k_t = k_n is CD_rot.
struct CDnt {
  static constexpr std::string_view name = "CD_nt";
  static constexpr bool rotates = true;
  static constexpr bool linear = true;
  static constexpr bool one_constant = false;
  static constexpr bool separate_constants = true;
  Real damping_normal;      ///< k_d^(n), [m / tau_e]
  Real damping_tangential;  ///< k_d^(t), [m / tau_e]

  Real normal_damping() const { return damping_normal; }
  Real tangential_damping() const { return damping_tangential; }

  /// The rate is convex in both constants, so at most that of CD_rot with k_t and CD_n with the
  /// rest.
  Real dense_flow_rate() const {
    Real const more = damping_normal - damping_tangential;
    return dense_flow::rolling * damping_tangential + dense_flow::normal * (more > 0 ? more : 0);
  }
  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }
  static CDnt make(DampingInput const& input) {
    Real const damping = 1 / input.elasticity;
    return {input.normal * damping, input.tangential * damping};
  }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    T const normal_part = T(damping_tangential - damping_normal) * dot(c.velocity, c.normal);
    return normal_part * c.normal - T(damping_tangential) * c.velocity;
  }
};
static_assert(is_contact_law<CDnt>());

}  // namespace bagnold
