// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/engine/simulation.hpp"

namespace bagnold {

struct Scene;

/// Simulation of a scene from a snapshot, at its strain rate or at those of its ramp, on a backend
/// by its name; "" takes the first of the build's. Throws InputError if the build does not have it;
/// a snapshot passed as an rvalue is then unchanged.
std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot&& snapshot,
                                            std::string const& backend);
std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot const& snapshot,
                                            std::string const& backend);

/// True if a backend works in memory that the host cannot access.
bool is_device_backend(std::string const& backend);

/// Reason why Kokkos cannot start on this machine, "" if it can. It starts all of its backends, so
/// a build with CUDA needs a device, whichever backend is used.
std::string why_no_start();

/// True if the replicas of a scene share launches. They do on a device, unless each is to be
/// evaluated on its own, as for its contacts.
bool steps_together(Scene const& scene, std::string const& backend);

/// Simulations of replicas that step together, from snapshots [R] with equal numbers of disks; to
/// be advanced as members_of says.
std::vector<std::unique_ptr<Simulation>> make_simulations(Scene const& scene,
                                                          std::vector<Snapshot> const& snapshots,
                                                          std::string const& backend);

/// Names of the backends in this build, the preferred one last.
std::vector<std::string> backend_names();

}  // namespace bagnold
