// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Checks a scene of one run as far as possible without its first state: check_feasible() and
/// check_target(). Throws InputError.
void validate_scene(Scene const& scene, Plan const& plan, bool allow_unstable);

/// Plan of the one run of a scene or, for a cascade, of its first; all runs are checked. Prints
/// warnings.
Plan validated_plan(Scene const& scene, bool allow_unstable);

}  // namespace bagnold
