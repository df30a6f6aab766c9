// SPDX-License-Identifier: BSD-3-Clause
//
// What a backend does: its bits beside those of the reference engine on Serial, or its time.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Kokkos_Core.hpp>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>

#include "bench/device/starts.hpp"
#include "kernels/device/initialize_kokkos.hpp"
#include "src/config/scene_file.hpp"
#include "src/engine/contacts/contact_record.hpp"
#include "src/engine/make_simulation.hpp"

namespace bagnold::bench {

namespace {

struct Options {
  std::string what, scene, backend = "cuda", order = "start", table;
  std::vector<std::string> set;
  std::int64_t steps = 1000, warm = 200, every = 10;
  bool contacts = false;
};

using Simulations = std::vector<std::unique_ptr<Simulation>>;
using Windows = std::vector<OpenWindows>;

Simulations simulations(Scene const& scene, std::vector<Snapshot> const& from,
                        std::string const& backend) {
  if (steps_together(scene, backend)) return make_simulations(scene, from, backend);
  Simulations all;
  for (auto const& snapshot : from) all.push_back(make_simulation(scene, snapshot, backend));
  return all;
}

/// With a record of contacts where these are asked for.
OpenWindows windows_of(Simulation const& simulation, Scene const& scene, bool contacts) {
  OpenWindows windows;
  if (contacts)
    windows.contacts =
        std::make_shared<ContactRecord>(static_cast<std::size_t>(scene.disks.count),
                                        simulation.columns(), 0, nullptr, SampleChoice(1));
  return windows;
}

Windows windows_of(Simulations const& all, Scene const& scene, bool contacts) {
  Windows windows;
  for (auto const& simulation : all) windows.push_back(windows_of(*simulation, scene, contacts));
  return windows;
}

void advance(Simulations const& all, std::int64_t steps, Sampling const& sampling,
             Windows& windows) {
  for (std::size_t s = 0; s < all.size(); ++s) all[s]->advance(steps, sampling, windows[s]);
}

/// Engine as the scene asks for it, and where on a device.
std::string engine_of(Scene const& scene, std::string const& backend) {
  return steps_together(scene, backend) ? "ensemble" : scene.integration.engine;
}

int time(Options const& options, Scene const& scene) {
  using Clock = std::chrono::steady_clock;
  auto const all = simulations(scene, starts(scene, options.order), options.backend);
  auto windows = windows_of(all, scene, options.contacts);
  Sampling const sampling{std::int64_t{1} << 40, options.every};
  advance(all, options.warm, sampling, windows);
  auto const builds = all[0]->snapshot().list_builds;
  auto const begun = Clock::now();
  advance(all, options.steps, sampling, windows);
  double const seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  auto const steps = static_cast<double>(options.steps);
  double const disk_steps = steps * static_cast<double>(scene.disks.count * scene.disks.replicas);
  auto const row = fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{:.4g},{:.4g},{:.4g}\n", options.backend, scene.disks.model,
      scene.disks.packing_fraction, scene.integration.scheme,
      engine_of(scene, options.backend) + (options.contacts ? " with contacts" : ""),
      scene.disks.count, scene.disks.replicas, options.order, options.every, options.steps,
      disk_steps / seconds / 1e6, 1e6 * seconds / steps,
      steps /
          static_cast<double>(std::max<std::int64_t>(1, all[0]->snapshot().list_builds - builds)));
  fmt::print("{}", row);
  if (!options.table.empty()) std::ofstream(options.table, std::ios::app) << row;
  return 0;
}

struct Difference {
  std::size_t numbers = 0, differ = 0;
  double largest = 0;

  void operator()(double a, double b) {
    ++numbers;
    if (std::memcmp(&a, &b, sizeof a) == 0) return;
    ++differ;
    largest = std::fmax(largest, std::isnan(a - b) ? HUGE_VAL : std::fabs(a - b));
  }
};

void compare(State const& a, State const& b, Difference& difference) {
  for (std::size_t i = 0; i < a.count(); ++i) {
    for (int c : {0, 1}) {
      difference(a.position[i][c], b.position[i][c]);
      difference(a.velocity[i][c], b.velocity[i][c]);
    }
    if (!a.spin.empty()) difference(a.spin[i], b.spin[i]);
  }
}

void compare(OpenWindows const& a, OpenWindows const& b, Difference& difference) {
  for (std::size_t w = 0; w < b.sums.size(); ++w)
    for (std::size_t c = 0; c < b.sums[w].sums.size(); ++c)
      difference(w < a.sums.size() ? a.sums[w].sums[c] : NAN, b.sums[w].sums[c]);
}

int bits(Options const& options, Scene scene) {
  auto const from = starts(scene, options.order);
  auto const all = simulations(scene, from, options.backend);
  auto const engine = engine_of(scene, options.backend);
  Sampling const sampling{options.steps, options.every, options.steps};
  auto windows = windows_of(all, scene, options.contacts);
  advance(all, options.steps, sampling, windows);
  scene.integration.engine = "reference";
  scene.disks.replicas = 1;
  Difference states, sums;
  for (std::size_t s = 0; s < all.size(); ++s) {
    auto const host = make_simulation(scene, from[s], "serial");
    auto expected = windows_of(*host, scene, options.contacts);
    host->advance(options.steps, sampling, expected);
    compare(all[s]->state(), host->state(), states);
    compare(windows[s], expected, sums);
  }
  bool const equal = states.differ + sums.differ == 0;
  fmt::print(
      "{} {} {} {} {} N={} R={} steps={}: of {} numbers of states {} differ, by at most {:.3g}; "
      "of {} sums {}, {:.3g}\n",
      equal ? "EQUAL " : "DIFFER", options.backend, scene.disks.model, scene.integration.scheme,
      engine, scene.disks.count, all.size(), options.steps, states.numbers, states.differ,
      states.largest, sums.numbers, sums.differ, sums.largest);
  return equal ? 0 : 1;
}

}  // namespace

}  // namespace bagnold::bench

int main(int argc, char** argv) {
  using namespace bagnold;
  CLI::App app(
      "Bits and times of a backend. Rows of times: backend, model, packing fraction, scheme, "
      "engine, disks, replicas, order, every, steps, million disk-steps/s, us a step, steps a "
      "list");
  bench::Options options;
  app.add_option("what", options.what,
                 "bits, beside those of the reference engine on Serial, or time")
      ->required()
      ->check(CLI::IsMember(std::vector<std::string>{"bits", "time"}));
  app.add_option("scene", options.scene, "a scene that starts from a state")->required();
  app.add_option("--set", options.set, "KEY=VALUE of the scene")->allow_extra_args(false);
  app.add_option("--backend", options.backend, "(cuda)");
  app.add_option("--order", options.order, "of disks in memory: start, shuffled, cells")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(bench::orders), std::end(bench::orders))));
  app.add_option("--steps", options.steps, "(1000)");
  app.add_option("--warm", options.warm, "steps before time is taken (200)");
  app.add_option("--every", options.every, "steps from one sample to the next (10)");
  app.add_flag("--contacts", options.contacts, "with the begins and ends of contacts");
  app.add_option("--table", options.table, "a file that a row of times is added to");
  CLI11_PARSE(app, argc, argv);
  if (auto const why = why_no_start(); !why.empty()) {
    fmt::print("no device: {}\n", why);
    return 2;
  }
  try {
    Scene const scene = read_scene(options.scene, options.set);
    initialize_kokkos(1);
    int const code =
        options.what == "bits" ? bench::bits(options, scene) : bench::time(options, scene);
    Kokkos::finalize();
    return code;
  } catch (std::exception const& error) {
    fmt::print("{}\n", error.what());
    return 3;
  }
}
