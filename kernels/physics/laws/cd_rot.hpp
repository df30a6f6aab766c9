// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/linear_damping.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Contact dissipation by the velocity difference at the point of contact, model CD_rot.
///
///     f_dis = -k_d (v_i^C - v_j^C)            PRE 95, 052903 (2017), Eq. (5)
///
/// The pair loop adds the torque, Eq. (7).
struct CDrot : LinearDamping<true, true> {
  static constexpr std::string_view name = "CD_rot";

  static Real paper_time_step(Real elasticity) { return time_step_of_p2(elasticity); }
  static CDrot make(DampingInput const& input) { return {1 / input.elasticity}; }
};
static_assert(is_contact_law<CDrot>());

}  // namespace bagnold
