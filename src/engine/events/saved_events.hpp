// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/engine/events/event_state.hpp"

namespace bagnold::events {

/// Arrays of a snapshot.
using Arrays = std::map<std::string, std::vector<double>>;

/// All that the bits of later events depend on, beside the lists: paths, and what contacts and
/// clusters begin with. The rest is a function of these.
template <bool Rotates>
Arrays save(EventDisks<Rotates> const& disks);

/// Names of disks in the order in which they are in memory.
std::vector<std::uint32_t> saved_order(Arrays const& from);

/// Of disks that have been placed where the lists were built; steps: of clusters.
template <bool Rotates>
void restore(Arrays const& from, EventState<Rotates>& state);

}  // namespace bagnold::events
