// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/linear_damping.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Contact dissipation by the difference of centre velocities, model CD.
///
///     f_dis = -k_d (v_i - v_j)                PRE 95, 052903 (2017), Eq. (3)
///
/// The force is not central: its stress is not symmetric.
struct CD : LinearDamping<true, false> {
  static constexpr std::string_view name = "CD";

  static Real paper_time_step(Real elasticity) { return time_step_of_p2(elasticity); }
  static CD make(DampingInput const& input) { return {1 / input.elasticity}; }
};
static_assert(is_contact_law<CD>());

}  // namespace bagnold
