// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/engine/events/event_state.hpp"

namespace bagnold::events {

/// Arrays of a snapshot.
using Arrays = std::map<std::string, std::vector<double>>;

/// All that the bits of later events depend on at a time, beside the lists: paths, what contacts
/// and clusters begin with, and sums of the window under way. The rest is a function of these.
template <bool Rotates>
Arrays save(EventState<Rotates> const& state, Real time);

/// Names of disks in the order in which they are in memory.
std::vector<std::uint32_t> saved_order(Arrays const& from);

/// Restores the events of disks that have been placed where the lists were built; steps: of
/// clusters.
template <bool Rotates>
void restore(Arrays const& from, EventState<Rotates>& state);

}  // namespace bagnold::events
