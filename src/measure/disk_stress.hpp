// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Contribution of each disk to the sums over pairs of SumColumns (the elastic and dissipative ones
/// and `contacts`), in the step that begins at `state`, by the scene's scheme. A disk has half of
/// each of its pairs, so that the sum over disks is the engine's sum. [N], in units of SumColumns;
/// columns of single disks are 0. state: in the box.
std::vector<Sums<false>> disk_stress(Scene const& scene, State const& state);

}  // namespace bagnold
