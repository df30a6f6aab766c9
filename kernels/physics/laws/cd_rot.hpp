// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/laws/dense_flow.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Contact dissipation by the velocity difference at the point of contact, model CD_rot.
///
///     f_dis = -k_d (v_i^C - v_j^C)            PRE 95, 052903 (2017), Eq. (5)
///
/// Force on i from j, [m d_s / tau_e^2]; the pair loop adds the torque, Eq. (7).
struct CDrot {
  static constexpr std::string_view name = "CD_rot";
  static constexpr bool rotates = true;
  static constexpr bool linear = true;
  static constexpr bool one_constant = true;  ///< k_t = k_n
  static constexpr bool separate_constants = false;
  Real damping;  ///< k_d, [m / tau_e]; 1/Q in reduced units

  Real normal_damping() const { return damping; }
  Real tangential_damping() const { return damping; }
  Real dense_flow_rate() const { return dense_flow::rolling * damping; }
  static Real paper_time_step(Real elasticity) { return time_step_of_p2(elasticity); }
  static CDrot make(DampingInput const& input) { return {1 / input.elasticity}; }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    return T(-damping) * c.velocity;
  }
};
static_assert(is_contact_law<CDrot>());

}  // namespace bagnold
