// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/laws/dense_flow.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Contact dissipation along the normal only, model CD_n.
///
///     f_dis = -k_d [(v_i - v_j) . n] n        PRE 95, 012902 (2017), Eq. (3)
///
/// Force on i from j, [m d_s / tau_e^2].
struct CDn {
  static constexpr std::string_view name = "CD_n";
  static constexpr bool rotates = false;  ///< a central force exerts no torque
  static constexpr bool linear = true;
  static constexpr bool one_constant = true;  ///< k_t = 0
  static constexpr bool separate_constants = false;
  Real damping;  ///< k_d, [m_0 / tau_e]; 1/Q in reduced units

  Real normal_damping() const { return damping; }
  Real tangential_damping() const { return 0; }
  Real dense_flow_rate() const { return dense_flow::normal * damping; }
  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }
  static CDn make(DampingInput const& input) { return {1 / input.elasticity}; }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    return T(-damping) * dot(c.velocity, c.normal) * c.normal;
  }
};
static_assert(is_contact_law<CDn>());

}  // namespace bagnold
