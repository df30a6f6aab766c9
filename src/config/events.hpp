// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

/// Contacts as events: an engine with its own scheme, for dilute flows.
namespace bagnold {

inline constexpr char event_engine[] = "events";  ///< integration.engine
/// integration.engine: events where most disks fly, steps of all disks where they touch.
inline constexpr char adaptive_engine[] = "adaptive";

inline constexpr char exact_contacts[] = "exact-contacts";  ///< its integration.scheme

/// "auto" time step of the event engine, [tau_e]. It is the unit of time for windows and frames and
/// affects nothing else.
inline constexpr double event_time_unit = 0.2;

bool has_events(Scene const& scene);
bool is_adaptive(Scene const& scene);

/// Smallest Q at which every contact of two disks alone is underdamped, so that it ends.
double least_underdamped_elasticity(Scene const& scene);

}  // namespace bagnold
