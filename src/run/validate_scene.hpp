// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// All that can be said against a scene of one run before its first state is there:
/// check_feasible() and check_target(). Throws InputError.
void validate_scene(Scene const& scene, Plan const& plan, bool allow_unstable);

/// The plan of the one run of a scene or, of a cascade, of its first, all runs checked; what is
/// worth a warning is said.
Plan validated_plan(Scene const& scene, bool allow_unstable);

}  // namespace bagnold
