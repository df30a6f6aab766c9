// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "src/engine/engine_input.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// Engine of quasi-static steps, for any law that is linear in the velocity, on one thread of the
/// host.
std::unique_ptr<Simulation> make_quasi_static(EngineInput const& input, Snapshot const& snapshot);

}  // namespace bagnold
