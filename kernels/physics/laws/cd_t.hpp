// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/laws/dense_flow.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Contact dissipation along the tangent only, at the point of contact: f_dis = -k_d v^C_t.
struct CDt {
  static constexpr std::string_view name = "CD_t";
  static constexpr bool rotates = true;
  static constexpr bool linear = true;
  static constexpr bool one_constant = false;
  static constexpr bool separate_constants = false;
  Real damping;  ///< k_d, [m / tau_e]; 1/Q in reduced units

  Real normal_damping() const { return 0; }
  Real tangential_damping() const { return damping; }
  Real dense_flow_rate() const { return dense_flow::rolling * damping; }
  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }
  static CDt make(DampingInput const& input) { return {1 / input.elasticity}; }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    T const normal_part = T(damping) * dot(c.velocity, c.normal);
    return normal_part * c.normal - T(damping) * c.velocity;
  }
};
static_assert(is_contact_law<CDt>());

}  // namespace bagnold
