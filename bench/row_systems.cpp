// SPDX-License-Identifier: BSD-3-Clause
#include "bench/row_systems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "kernels/physics/schemes/modified_velocity_verlet.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/io/state_file.hpp"
#include "src/run/replica_scheduler.hpp"
#include "src/start/start.hpp"

namespace bagnold::bench {

namespace {

constexpr std::int64_t fewest_steps = 20;

/// Engines that do every step would take hours for a strain at small rates.
double most_disk_steps(std::string const& engine) {
  if (engine == "reference") return 4e7;
  return engine == "few-contacts" || engine == "many-contacts" ? 2.5e8 : 1e12;
}

/// With more threads than are used the others wait busily beside what is timed.
void check_threads(int needed, int there) {
  if (there != needed)
    throw InputError(fmt::format("--threads = {} (must be {} here)", there, needed));
}

Scene scene_of(Row const& row, std::string const& engine, RowOptions const& options) {
  auto const folder = std::filesystem::path(options.states) / row.state;
  for (auto const& file : {folder / "scene.toml", folder / "state.h5"})
    if (!std::filesystem::exists(file))
      throw InputError(file.string() + " is missing; `scripts/bench states` makes it");
  Scene scene = read_scene(folder / "scene.toml");
  scene.start.kind = "state";
  scene.start.file = (folder / "state.h5").string();
  scene.integration = {};
  if (engine != "default") {
    scene.integration.engine = engine;
    scene.integration.scheme = ModifiedVelocityVerlet::name;
    scene.integration.time_step = 0.05;
  }
  scene.measure = {};
  scene.output = {};
  double const step_strain = time_step(scene) * scene.shear.strain_rate;
  double const most_steps = most_disk_steps(engine) / static_cast<double>(scene.disks.count);
  scene.shear.strain = std::max(static_cast<double>(fewest_steps) * step_strain,
                                std::min(row.strain, most_steps * step_strain) / options.shorter);
  return scene;
}

}  // namespace

RowSystems::RowSystems(Row const& row, std::string const& engine, RowOptions const& options)
    : scene_(scene_of(row, engine, options)),
      plan_(make_plan(scene_)),
      side_by_side_(row.side_by_side),
      untimed_(plan_.steps / 10) {
  plan_.steps += untimed_;
  plan_.windows = (plan_.steps + plan_.window_steps - 1) / plan_.window_steps;
  auto started = fit_to_scene(io::read_states(scene_.start.file), scene_);
  check_threads(row.threads, options.threads);
  measurements_.resize(started.size());
  for (std::size_t r = 0; r < started.size(); ++r) {
    simulations_.push_back(make_simulation(scene_, first_snapshot(std::move(started[r].state)),
                                           row.threads > 1 ? "openmp" : "serial"));
    measurements_[r].windows.columns = static_cast<std::size_t>(simulations_[r]->columns());
    simulations_[r]->advance(untimed_, {plan_.window_steps, plan_.every, untimed_},
                             measurements_[r].open);
  }
}

void RowSystems::run() {
  ReplicaScheduler all;
  all.systems = simulations_.size();
  all.threads = side_by_side_;
  all.advance = [&](std::size_t r, std::function<bool()> const& go_on) {
    return run_measured(*simulations_[r], plan_, measurements_[r], go_on);
  };
  bagnold::run(all);
}

Counts RowSystems::counts() const {
  Counts sum;
  for (auto const& simulation : simulations_) {
    Snapshot snapshot = simulation->snapshot();
    auto& counters = snapshot.counters;  // empty for the reference, which counts builds only
    sum.pairs += counters["pairs_evaluated"];
    sum.prunings += counters["prunings"];
    sum.builds += static_cast<double>(snapshot.list_builds);
    sum.one_by_one += counters["steps_one_by_one"];
    sum.looking_ahead += counters["lookahead_steps"];
  }
  return sum;
}

double RowSystems::disk_steps() const {
  return static_cast<double>((plan_.steps - untimed_) * scene_.disks.count *
                             static_cast<std::int64_t>(simulations_.size()));
}

double RowSystems::strain() const {
  return static_cast<double>(plan_.steps - untimed_) * plan_.time_step * scene_.shear.strain_rate;
}

}  // namespace bagnold::bench
