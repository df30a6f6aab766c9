// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/config/scene.hpp"
#include "src/measure/observable.hpp"

namespace bagnold {

/// All observables of a scene in their order of output; `strain_rate` in [1/tau_e], `box_length` in
/// [d_s]. Observables of the spin exist only where the law rotates.
std::vector<Observable> observables(Scene const& scene, double box_length);

}  // namespace bagnold
