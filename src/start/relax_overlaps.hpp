// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "src/config/scene.hpp"
#include "src/start/push_apart.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Pushes overlapping disks apart at rest until the largest relative overlap is below `overlap` or
/// the iterations are used up: gradient descent with momentum on the elastic energy. Deep overlaps
/// are relaxed one iteration at a time, all others by the block engine, as undamped disks in a
/// fluid at rest. Runs on the host; the bits do not depend on the backend. Throws StartStopped if
/// go_on, asked every ten iterations, returns false.
Relaxation relax_overlaps(
    State& state, double overlap, std::int64_t iterations, double skin,
    std::function<bool()> const& go_on = [] { return true; });

/// Relaxes a state by the keys of a scene; throws NumericalError if more than largest_start_overlap
/// is left. Writes `start_iterations` and `start_overlap` into `record`. what: name of the state in
/// messages.
void relax_start(State& state, Scene const& scene, std::string const& what,
                 std::map<std::string, double>& record, std::function<bool()> const& go_on);

}  // namespace bagnold
