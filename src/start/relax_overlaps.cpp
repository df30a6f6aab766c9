// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/relax_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "kernels/physics/drives/stokes_drag.hpp"
#include "kernels/physics/laws/cd_n.hpp"
#include "src/config/errors.hpp"
#include "src/config/jamming.hpp"
#include "src/config/names.hpp"
#include "src/config/scene.hpp"
#include "src/config/skin.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/start/deep_overlaps.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// Relative overlap above which disks are pushed apart one iteration at a time: engines refuse such
/// overlaps.
constexpr double deep = 0.1;

/// Scene of undamped disks in a fluid at rest: gradient descent with momentum on the elastic
/// energy, one step for each iteration.
Scene relaxing_scene(State const& state, double skin) {
  constexpr double keep = 0.985;  // share of the velocity kept: waves as long as the box die out
  Scene scene;
  auto const built = model_names();  // CD_n may be missing in a developer's build (BAGNOLD_LAWS)
  scene.disks.model = std::ranges::count(built, CDn::name) > 0 ? CDn::name : built.front();
  scene.disks.count = static_cast<std::int64_t>(state.count());
  scene.disks.elasticity = 1e6;
  scene.disks.mass = "equal";
  scene.integration.engine = "many-contacts";
  scene.integration.time_step = 0.3;  // below 2/omega_max, omega_max^2 about 10 at Z = 5
  scene.integration.skin = skin;
  scene.drive = {std::string(StokesDrag::name), -std::log(keep) / 0.3, 0};
  return scene;
}

using Host = Kokkos::DefaultHostExecutionSpace;

/// True if threads pay. Those of few disks mostly wait for each other, and replicas have a thread
/// each.
bool worth_threads(State const& state) {
#ifdef KOKKOS_ENABLE_SERIAL
  return is_large(state) && Host().concurrency() > 1;
#else
  return true;
#endif
}

/// Continues a relaxation. Returns false if disks came too close for an engine; the state is then
/// that of some iterations before.
bool relax_in_blocks(State& state, Relaxation& relaxed, double overlap, std::int64_t iterations,
                     double skin, std::function<bool()> const& go_on) try {
  Scene const scene = relaxing_scene(state, skin);
  State resting = state;
  resting.velocity.assign(state.count(), {0.0, 0.0});
  resting.spin.assign(scene.rotates() ? state.count() : 0, 0.0);
  std::string const backend =
      worth_threads(state) ? std::string(backend_name<Host>) : backend_names().front();
  auto const simulation = make_simulation(scene, first_snapshot(std::move(resting)), backend);
  OpenWindows windows;
  while (relaxed.largest_overlap > overlap && relaxed.iterations < iterations) {
    auto const next =
        std::min(iterations, relaxed.iterations + std::max(between_checks, relaxed.iterations / 8));
    while (relaxed.iterations < next) {
      if (!go_on()) throw StartStopped{};
      auto const more = std::min(between_checks, next - relaxed.iterations);
      simulation->advance(more, Sampling{}, windows);
      relaxed.iterations += more;
    }
    State reached = simulation->state();
    relaxed.largest_overlap = largest_overlap(reached);
    state.position = std::move(reached.position);
  }
  return true;
} catch (NumericalError const&) {
  return false;
}

/// Indices of the disks strip by strip, so that neighbours in the box are near in memory.
std::vector<std::size_t> by_strips(State const& state) {
  constexpr double height = 4;  // [d_s]
  std::vector<std::size_t> order(state.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) {
    auto const& [x, y] = state.position[i];
    return std::tuple(std::floor(y / height), x, i);
  });
  return order;
}

Relaxation relax_in_order(State& state, double overlap, std::int64_t iterations, double skin,
                          std::function<bool()> const& go_on) {
  Relaxation relaxed{0, 0};
  for (double limit = deep;; limit /= 2) {
    auto const begun = push_apart(state, std::max(limit, overlap), iterations - relaxed.iterations,
                                  skin, worth_threads(state), go_on);
    relaxed = {relaxed.iterations + begun.iterations, begun.largest_overlap};
    if (relaxed.largest_overlap <= overlap || relaxed.iterations >= iterations) break;
    if (relax_in_blocks(state, relaxed, overlap, iterations, skin, go_on)) break;
  }
  return relaxed;
}

}  // namespace

Relaxation relax_overlaps(State& state, double overlap, std::int64_t iterations, double skin,
                          std::function<bool()> const& go_on) {
  if (!is_large(state)) return relax_in_order(state, overlap, iterations, skin, go_on);
  auto const order = by_strips(state);
  State sorted = state;
  for (std::size_t k = 0; k < order.size(); ++k) {
    sorted.position[k] = state.position[order[k]];
    sorted.diameter[k] = state.diameter[order[k]];
  }
  auto const relaxed = relax_in_order(sorted, overlap, iterations, skin, go_on);
  for (std::size_t k = 0; k < order.size(); ++k) state.position[order[k]] = sorted.position[k];
  return relaxed;
}

void relax_start(State& state, Scene const& scene, std::string const& what,
                 std::map<std::string, double>& record, std::function<bool()> const& go_on) {
  auto const& start = scene.start;
  auto const [iterations, overlap] =
      relax_overlaps(state, start.overlap, start.iterations,
                     scene.integration.skin.number.value_or(usual_skin), go_on);
  record["start_iterations"] = static_cast<double>(iterations);
  record["start_overlap"] = overlap;
  if (overlap > largest_start_overlap)
    throw NumericalError(fmt::format(
        "after {} iterations of relaxing {} an overlap of {:.1f}% is left (limit "
        "{:.0f}%); lower disks.packing_fraction = {}, or {}",
        iterations, what, 100 * overlap, 100 * largest_start_overlap, scene.disks.packing_fraction,
        scene.disks.packing_fraction > jamming_fraction
            ? "compress a looser state by shear.protocol = \"pressure\": so far above "
              "jamming overlaps remain however long it relaxes"
            : fmt::format("raise start.iterations = {}", start.iterations)));
}

}  // namespace bagnold
