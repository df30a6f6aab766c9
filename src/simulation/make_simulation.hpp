// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/config/scene.hpp"
#include "src/simulation/simulation.hpp"

namespace bagnold {

/// The simulation of a scene from a snapshot, on a backend by its name; "" takes the first of the
/// build's. Throws InputError where the build does not have it.
std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot const& snapshot,
                                            std::string const& backend);

/// Names of the backends in this build, the preferred one last.
std::vector<std::string> backend_names();

}  // namespace bagnold
