// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "src/config/refusal.hpp"
#include "src/config/scene.hpp"

/// Contacts as events: an engine of its own, with a scheme of its own, for dilute flows.
namespace bagnold {

inline constexpr char event_engine[] = "events";  ///< integration.engine
/// integration.engine: events where most disks fly, steps of all disks where they touch.
inline constexpr char adaptive_engine[] = "adaptive";

inline constexpr char exact_contacts[] = "exact-contacts";  ///< its integration.scheme

/// Its "auto" step, a unit of time for windows and frames that acts on nothing else, [tau_e].
inline constexpr double event_time_unit = 0.2;

bool has_events(Scene const& scene);
bool is_adaptive(Scene const& scene);

/// Whether a scheme is that of one engine alone, which needs no time step to be stable.
bool is_scheme_of_an_engine(std::string_view scheme);

/// Smallest Q at which every contact of two alone ends of itself, as an oscillation.
double least_underdamped_elasticity(Scene const& scene);

/// What events cannot do of a scene that asks for them, by themselves or by turns with steps, and
/// their scheme in scenes of others.
std::vector<Refusal> not_events(Scene const& scene);

}  // namespace bagnold
