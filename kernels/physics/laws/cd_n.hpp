// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/linear_damping.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Contact dissipation along the normal only, model CD_n. A central force, it exerts no torque.
///
///     f_dis = -k_d [(v_i - v_j) . n] n        PRE 95, 012902 (2017), Eq. (3)
struct CDn : LinearDamping<false, false> {
  static constexpr std::string_view name = "CD_n";

  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }
  static CDn make(DampingInput const& input) { return {1 / input.elasticity}; }
};
static_assert(is_contact_law<CDn>());

}  // namespace bagnold
