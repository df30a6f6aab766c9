// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/linear_damping.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"

namespace bagnold {

/// Separate damping along the normal and the tangent, at the point of contact, model CD_nt.
///
///     f_dis = -k_n (v^C . n) n - k_t [v^C - (v^C . n) n]     PRE 95, 052903 (2017), end of Sec. II
///     B
///
/// k_t = 0 is CD_n, k_t = k_n is CD_rot.
struct CDnt : SeparateDamping<true> {
  static constexpr std::string_view name = "CD_nt";

  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }
  static CDnt make(DampingInput const& input) {
    Real const damping = 1 / input.elasticity;
    return {input.normal * damping, input.tangential * damping};
  }
};
static_assert(is_contact_law<CDnt>());

}  // namespace bagnold
