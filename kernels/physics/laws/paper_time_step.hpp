// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/physics/vec2.hpp"

/// Time steps of the papers at an elasticity Q, [tau_e]; each law uses one of them.
namespace bagnold {

/// min{0.5/Q, 0.1, 0.2 Q}     P1 Sec. II C
inline Real time_step_of_p1(Real elasticity) {
  return std::min({0.5 / elasticity, 0.1, 0.2 * elasticity});
}

/// 0.05, and below Q = 0.5 max(0.01, 0.1 Q)     P2 Sec. II D, which says "down to 0.01"
inline Real time_step_of_p2(Real elasticity) {
  return elasticity < 0.5 ? std::max(0.01, 0.1 * elasticity) : 0.05;
}

}  // namespace bagnold
