// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "src/config/refusal.hpp"
#include "src/config/scene.hpp"

/// Quasi-static steps: an engine of its own, with a scheme of its own, for dense flows that creep.
namespace bagnold {

inline constexpr char quasi_static_engine[] = "quasi-static";  ///< integration.engine
inline constexpr char backward_euler[] = "backward-euler";     ///< its integration.scheme

/// Largest integration.time_step of other engines, [tau_e].
inline constexpr double longest_explicit_step = 10;

bool is_quasi_static(Scene const& scene);

/// Its "auto" step, a strain of 1e-3: [tau_e]
double quasi_static_time_step(Scene const& scene);

/// What the engine cannot do of a scene that asks for it.
std::vector<Refusal> not_quasi_static(Scene const& scene);

/// What other engines do better (docs/accuracy.md, "Quasi-static steps"), and keys that belong to
/// this engine in scenes of others.
std::vector<Refusal> misused_quasi_static(Scene const& scene);

}  // namespace bagnold
