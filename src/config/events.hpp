// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

/// Contacts as events: an engine with its own scheme, for dilute flows.
namespace bagnold {

inline constexpr char event_engine[] = "events";  ///< integration.engine
inline constexpr char steps_engine[] = "steps";   ///< what "auto" takes where it takes no events

inline constexpr char exact_contacts[] = "exact-contacts";  ///< its integration.scheme

/// "auto" time step of the event engine, [tau_e]. It is the unit of time for windows, frames and
/// builds of the lists, and affects nothing else.
inline constexpr double event_time_unit = 0.2;

/// Longest time step of the event engine, [tau_e]: lists are built where a step ends, up to which a
/// disk that leaves its reach flies on.
inline constexpr double longest_event_unit = 1;

bool has_events(Scene const& scene);

/// Whether integration.engine = "auto" chooses between events and steps. It does where both can run
/// the scene, with the default scheme and its time step.
bool may_take_events(Scene const& scene);

/// Smallest Q at which every contact of two disks alone is underdamped, so that it ends.
double least_underdamped_elasticity(Scene const& scene);

}  // namespace bagnold
