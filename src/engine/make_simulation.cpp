// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/make_simulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "src/config/errors.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/ensemble/ensemble.hpp"
#include "src/engine/law_engines.hpp"
#include "src/engine/levels/levels.hpp"

namespace bagnold {

namespace {

/// The engine of a scene on a backend; nullptr if the build has no such backend.
std::unique_ptr<Simulation> make_engine(Scene const& scene, Snapshot& snapshot,
                                        std::string const& backend) {
  auto const drive = drive_setup(scene, snapshot.initial_time);
  if (scene.integration.engine != "reference")
    if (auto made = level_of(scene).make(scene, snapshot, drive, backend)) return made;
  return engines_for(scene).reference(scene, snapshot, drive, backend);
}

template <class... Spaces>
bool is_any_device(std::tuple<Spaces...> const*, std::string const& backend) {
  return ((is_device<Spaces> && backend == backend_name<Spaces>) || ...);
}

template <class... Spaces>
std::vector<std::string> names(std::tuple<Spaces...> const*) {
  return {std::string(backend_name<Spaces>)...};
}

/// Disks up to which a team, so one multiprocessor, should be as quick as launches for each step.
constexpr std::int64_t most_disks_of_a_team = 1024;

/// Whether nothing is asked for that members of an ensemble do not do.
bool suits_ensembles(Scene const& scene) {
  return scene.integration.engine != "reference" && !scene.measure.contacts && !scene.driven();
}

}  // namespace

std::vector<std::string> backend_names() { return names(static_cast<Backends const*>(nullptr)); }

bool is_device_backend(std::string const& backend) {
  return is_any_device(static_cast<Backends const*>(nullptr), backend);
}

std::string why_no_start() {
#ifdef KOKKOS_ENABLE_CUDA
  int devices = 0;
  if (auto const error = cudaGetDeviceCount(&devices); error != cudaSuccess)
    return cudaGetErrorString(error);
#endif
  return "";
}

std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot const& snapshot,
                                            std::string const& backend) {
  return make_simulation(scene, Snapshot(snapshot), backend);
}

std::unique_ptr<Simulation> make_simulation(Scene const& scene, Snapshot&& snapshot,
                                            std::string const& backend) {
  auto const chosen = backend.empty() ? backend_names().front() : backend;
  if (is_device_backend(chosen) && suits_ensembles(scene) &&
      static_cast<std::int64_t>(snapshot.state.count()) <= most_disks_of_a_team)
    return std::move(make_simulations(scene, {snapshot}, chosen).front());
  auto made = make_engine(scene, snapshot, chosen);
  if (!made)
    throw InputError(fmt::format("--backend {}: not in this build (has: {})", backend,
                                 fmt::join(backend_names(), ", ")));
  return made;
}

bool steps_together(Scene const& scene, std::string const& backend) {
  return is_device_backend(backend) && scene.disks.replicas > 1 && suits_ensembles(scene);
}

std::vector<std::unique_ptr<Simulation>> make_simulations(Scene const& scene,
                                                          std::vector<Snapshot> const& snapshots,
                                                          std::string const& backend) {
  return members_of(engines_for(scene).ensemble(scene, snapshots, backend));
}

}  // namespace bagnold
