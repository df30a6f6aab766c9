// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// Scheme of a scene: as given. For "auto" it is two stages, in whose steps a run is counted
/// (implicit_step_length()). For quasi-static steps it is backward Euler, which is not in Schemes.
std::string_view scheme_of(Scene const& scene);

/// Time step of the papers for a law, [tau_e], see kernels/physics/laws/paper_time_step.hpp.
double paper_time_step(Scene::Disks const& disks);

/// The time step of a scheme's own rule, [tau_e].
double rule_time_step(Scene const& scene, std::string_view scheme);

/// Length of a step of implicit damping in steps of two stages, where scheme = "auto" may change
/// between them. 1 where it does not: with a drive, a ramp or contacts to report, a law that leaves
/// sliding contacts undamped, the papers' step, an engine without implicit damping, or steps that
/// gain too little.
std::int64_t implicit_step_length(Scene const& scene);

/// Largest rate at which the drag of a drive relaxes a disk alone, [1 / tau_e]; 0 without one.
double drag_rate(Scene const& scene);

/// Time step of a scene: as given, or by the rule named, with a drive at most 0.2/drag_rate(); of a
/// ramp shortened to divide ramp_every. For quasi-static steps a strain of 1e-3.
double time_step(Scene const& scene);

/// Scene with scheme and time step resolved, as kept with results. Left unresolved: the step of
/// quasi-static cascades, and "auto" where it changes between schemes.
Scene resolved(Scene scene);

}  // namespace bagnold
