// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/make_simulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/abilities.hpp"
#include "src/config/errors.hpp"
#include "src/config/events.hpp"
#include "src/config/ladder.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/scene.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/auto_scheme/auto_scheme.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/ensemble/ensemble.hpp"
#include "src/engine/events/adaptive_engine.hpp"
#include "src/engine/events/make_events.hpp"
#include "src/engine/law_engines.hpp"
#include "src/engine/levels/levels.hpp"
#include "src/engine/quasi_static/make_quasi_static.hpp"

namespace bagnold {

namespace {

/// Throws InputError where the engine of a scene cannot run it, or not on this backend.
void require_able(Scene const& scene, std::string const& backend) {
  auto const built = backend_names();
  if (std::ranges::count(built, backend) == 0)
    throw InputError(
        fmt::format("--backend {}: not in this build (has: {})", backend, fmt::join(built, ", ")));
  auto const& able = abilities_of(scene);
  if (!able.scheme.empty())  // others step what only scenes that are read are refused
    for (auto const& refusal : why_not(scene)) throw InputError(refusal.message);
  if (is_device_backend(backend) && !able.devices.empty())
    throw InputError(
        fmt::format("--backend {} (integration.engine = \"{}\" {}); use --backend serial", backend,
                    able.engine, able.devices));
}

/// The engine of a scene on a backend of this build.
std::unique_ptr<Simulation> make_engine(Scene const& scene, Snapshot& snapshot,
                                        std::string const& backend) {
  auto const input = engine_input(scene, snapshot.initial_time);
  if (is_quasi_static(scene)) return make_quasi_static(input, snapshot);
  if (has_events(scene)) return make_events(input, snapshot, backend);
  if (scene.integration.engine != "reference") {
    auto const& level = level_of(scene.disks.model, scene.drive.kind);
    if (auto made = level.make(input, snapshot, backend)) return made;
  }
  return engines_for(input.model).reference(input, snapshot, backend);
}

template <class... Spaces>
bool is_any_device(std::tuple<Spaces...> const*, std::string const& backend) {
  return ((is_device<Spaces> && backend == backend_name<Spaces>) || ...);
}

template <class... Spaces>
std::vector<std::string> names(std::tuple<Spaces...> const*) {
  return {std::string(backend_name<Spaces>)...};
}

/// Makes engines of a scene that go on from snapshots.
auto maker_of(Scene const& scene, std::string const& backend) {
  return [scene, backend](Snapshot&& from) { return make_engine(scene, from, backend); };
}

/// Engine of a scene in which events and steps of all disks take turns.
std::unique_ptr<Simulation> make_adaptive(Scene const& scene, Snapshot&& snapshot,
                                          std::string const& backend) {
  double const dt = time_step(scene);
  Scene events = scene, steps = scene;
  events.integration.engine = event_engine;
  events.integration.scheme = exact_contacts;
  events.integration.skin = automatic;
  steps.integration.engine = steps_engine;
  steps.integration.scheme = scheme_of(scene);
  for (auto* of : {&events, &steps}) of->integration.time_step = dt;
  return std::make_unique<AdaptiveEngine>(
      AdaptiveEngine::Engines{
          maker_of(events, backend), maker_of(steps, backend), dt,
          events::EventChoice::stretch(scene.shear.strain_rate * dt, !scene.shear.ramps())},
      std::move(snapshot));
}

/// Throws InputError where a device cannot go on from what the host has written.
void require_steps(Snapshot const& snapshot, std::string const& backend) {
  if (is_device_backend(backend) && AdaptiveEngine::wrote_by_events(snapshot))
    throw InputError(fmt::format(
        "--backend {} (the checkpoint is of contacts as events, which the host alone has); use "
        "--backend serial",
        backend));
}

/// True if events and steps of all disks take turns: from a start on, or where they did before. A
/// run whose checkpoint is of steps alone keeps to them.
bool goes_by_turns(Scene const& scene, Snapshot const& snapshot, std::string const& backend) {
  return !is_device_backend(backend) && may_take_events(scene) &&
         (snapshot.list_position.empty() || AdaptiveEngine::wrote(snapshot));
}

/// Engine of a scene with one method.
std::unique_ptr<Simulation> make_of_method(Scene const& scene, Snapshot&& snapshot,
                                           std::string const& backend) {
  if (goes_by_turns(scene, snapshot, backend))
    return make_adaptive(scene, std::move(snapshot), backend);
  return make_engine(scene, snapshot, backend);
}

/// Engine of a scene whose method may change during the run.
std::unique_ptr<Simulation> make_choosing(Scene const& scene, Snapshot&& snapshot,
                                          std::string const& backend) {
  return std::make_unique<AutoScheme>(ladder_of(scene), std::move(snapshot),
                                      [scene, backend](Method const& method, Snapshot&& from) {
                                        return make_of_method(with_method(scene, method),
                                                              std::move(from), backend);
                                      });
}

/// Disks up to which a team, so one multiprocessor, should be as quick as launches for each step.
constexpr std::int64_t most_disks_of_a_team = 1024;

constexpr Abilities ensembles = {.engine = "auto",
                                 .drives = "has none in systems that share launches",
                                 .pieces = "scales motions, which shear.protocol = \"{}\" keeps",
                                 .contacts = "follows none in systems that share launches"};

/// True if members of an ensemble can run the scene.
bool suits_ensembles(Scene const& scene) {
  return scene.integration.engine != "reference" && abilities_of(scene).devices.empty() &&
         why_not(scene, ensembles).empty();
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
  require_able(scene, chosen);
  require_steps(snapshot, chosen);
  if (is_device_backend(chosen) && suits_ensembles(scene) &&
      static_cast<std::int64_t>(snapshot.state.count()) <= most_disks_of_a_team)
    return std::move(make_simulations(scene, {snapshot}, chosen).front());
  if (may_change_method(scene)) return make_choosing(scene, std::move(snapshot), chosen);
  return make_of_method(scene, std::move(snapshot), chosen);
}

bool steps_together(Scene const& scene, std::string const& backend) {
  return is_device_backend(backend) && scene.disks.replicas > 1 && suits_ensembles(scene);
}

std::vector<std::unique_ptr<Simulation>> make_simulations(Scene const& scene,
                                                          std::vector<Snapshot> const& snapshots,
                                                          std::string const& backend) {
  for (auto const& snapshot : snapshots) require_steps(snapshot, backend);
  return members_of(
      engines_for(scene.disks.model).ensemble(engine_input(scene), snapshots, backend));
}

}  // namespace bagnold
