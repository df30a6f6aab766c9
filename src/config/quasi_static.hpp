// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/config/refusal.hpp"
#include "src/config/scene.hpp"
#include "src/config/schemes.hpp"

/// Quasi-static steps: an engine with its own scheme, for dense flows that creep.
namespace bagnold {

/// integration.engine, whose scheme is backward_euler.
inline constexpr char quasi_static_engine[] = "quasi-static";

/// Largest integration.time_step of other engines, [tau_e].
inline constexpr double longest_explicit_step = 10;

bool is_quasi_static(Scene const& scene);

/// "auto" time step of the quasi-static engine, a strain of 1e-3, [tau_e].
double quasi_static_time_step(Scene const& scene);

/// Refusals of scenes that other engines run better (docs/accuracy.md, "Quasi-static steps"), and
/// of its long steps in scenes of others.
std::vector<Refusal> misused_quasi_static(Scene const& scene);

}  // namespace bagnold
