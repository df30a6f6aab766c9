// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "src/config/scene.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// Engine of quasi-static steps, for any law that is linear in the velocity. Throws InputError for
/// a scene that it cannot run, or for a backend that is a device; nullptr if the build does not
/// have the backend.
std::unique_ptr<Simulation> make_quasi_static(Scene const& scene, Snapshot const& snapshot,
                                              std::string const& backend);

}  // namespace bagnold
