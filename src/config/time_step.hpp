// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "src/config/scene.hpp"

namespace bagnold {

/// The scheme of a scene: as given, or where it is "auto" two stages, whose steps a run then counts
/// (implicit_step_length()). Of quasi-static steps backward Euler, which is none of Schemes.
std::string_view scheme_of(Scene const& scene);

/// The papers' time step of a law, [tau_e], see kernels/physics/laws/paper_time_step.hpp.
double paper_time_step(Scene::Disks const& disks);

/// The time step of a scheme's own rule, [tau_e].
double rule_time_step(Scene const& scene, std::string_view scheme);

/// How many steps of two stages a step of implicit damping is long where scheme = "auto" may change
/// between them; 1 where it does not: with a drive, a ramp or contacts to report, a law that leaves
/// sliding contacts undamped, the papers' step, an engine that lacks implicit damping, or steps
/// that gain too little.
std::int64_t implicit_step_length(Scene const& scene);

/// Largest rate at which the drag of a drive relaxes a disk alone, [1 / tau_e]; 0 without one.
double drag_rate(Scene const& scene);

/// The time step of a scene: as given, or by the rule named, with a drive at most 0.2/drag_rate();
/// of a ramp shortened to divide ramp_every. Of quasi-static steps a strain of 1e-3.
double time_step(Scene const& scene);

/// The scene with scheme and time step told, as kept with results; not the step of quasi-static
/// cascades, nor "auto" where it changes between schemes.
Scene resolved(Scene scene);

}  // namespace bagnold
