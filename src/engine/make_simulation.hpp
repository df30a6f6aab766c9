// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/config/scene.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// The simulation of a scene from a snapshot, at its strain rate or at those of its ramp, on a
/// backend by its name; "" takes the first of the build's. Throws InputError where the build does
/// not have it. A snapshot that may be moved from is left as it was where this throws.
std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot&& snapshot,
                                            std::string const& backend);
std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot const& snapshot,
                                            std::string const& backend);

/// Whether a backend works in memory that the host does not reach.
bool is_device_backend(std::string const& backend);

/// Why Kokkos cannot start on this machine, "" if it can: it starts all of its backends, so one
/// with CUDA wants a device, whichever backend is to be used.
std::string why_no_start();

/// Whether the replicas of a scene are stepped by launches that they share, as on a device they
/// are, unless each is to be looked at on its own: its contacts.
bool steps_together(Scene const& scene, std::string const& backend);

/// The simulations of replicas that step together, from snapshots [R] of equally many disks; to be
/// advanced as members_of says.
std::vector<std::unique_ptr<Simulation>> make_simulations(Scene const& scene,
                                                          std::vector<Snapshot> const& snapshots,
                                                          std::string const& backend);

/// Names of the backends in this build, the preferred one last.
std::vector<std::string> backend_names();

}  // namespace bagnold
