// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "kernels/physics/schemes/modified_velocity_verlet.hpp"
#include "kernels/physics/schemes/two_stage_leapfrog.hpp"

namespace bagnold {

/// Every scheme there is; the first is taken where a scene says "auto".
using Schemes = std::tuple<TwoStageLeapfrog, ModifiedVelocityVerlet>;

}  // namespace bagnold
