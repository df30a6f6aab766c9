// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "src/engine/engine_input.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// The engine of contacts as events, for any law that is linear in the velocity, on a backend of
/// the host.
std::unique_ptr<Simulation> make_events(EngineInput const& input, Snapshot const& snapshot,
                                        std::string const& backend);

}  // namespace bagnold
