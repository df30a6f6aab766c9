// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Change of all motions where the strain rate changes between steps: either they are scaled with
/// it, P2 Eqs. (40)-(41), or they keep their excess over the mean flow,
///
///     v -> factor v + rise y x^,    thetadot -> factor thetadot - rise/2.
struct RateChange {
  Real factor = 1;
  Real rise = 0;  ///< of the strain rate, [1/tau_e]
};

}  // namespace bagnold
