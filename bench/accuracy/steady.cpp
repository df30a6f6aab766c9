// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <limits>

#include "bench/accuracy/commands.hpp"
#include "bench/accuracy/start.hpp"
#include "src/measure/observables.hpp"
#include "src/statistics/estimate.hpp"

namespace bagnold::accuracy {

namespace {

struct Steady {
  Start start;
  std::string method = "two-stage:0.2";
  double strain = 10, discard = 1, window = 0.02, every = 0.2;
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr char const* quantities[] = {"B_p", "B_p_el", "B_p_kin", "B_sigma",
                                      "Z",   "mu",     "T_g",     "R_v"};

void print_header() {
  fmt::print("{},{},strain,evaluations,passes,cpu_seconds,gap", scene_header, method_header);
  for (auto const* name : quantities) fmt::print(",{},{}_error", name, name);
  fmt::print(",status\n");
}

/// Share of the work that the energy balance misses, from samples `time` apart at the ends.
double energy_gap(std::vector<double> const& mean, Sample const& first, Sample const& last,
                  double rate, double time) {
  double const work = -rate * (mean[SumColumns::elastic_xy] + mean[SumColumns::dissipative_xy] +
                               mean[SumColumns::kinetic_xy]);
  auto const energy = [](Sample const& s) {
    return s.value[Sample::kinetic_energy] + s.value[Sample::elastic_energy];
  };
  return (work - mean[Sample::dissipated] - (energy(last) - energy(first)) / time) / work;
}

void run(Steady& o) {
  State const state = o.start.read();
  Scene& scene = o.start.scene;
  Method const method = read_method(o.method);
  scene.integration.time_step = method.time_step;
  double const step_strain = scene.shear.strain_rate * method.time_step;
  auto const steps = [&](double strain) { return std::llround(strain / step_strain); };
  auto const every = std::max(1LL, std::llround(o.every / method.time_step));
  auto const samples_a_window = std::max(1LL, steps(o.window) / every);

  print_header();
  fmt::print("{},{},", scene_columns(scene), method_columns(method));
  auto const system = make_system(scene, state, method);
  statistics::Windows windows;
  windows.columns = Sample::count;
  Sample first, last;
  long long samples = 0;
  double seconds = 0;
  Counts before;
  try {
    for (long long k = 0; k < steps(o.discard); ++k) system->step(nullptr);
    before = system->counts();
    seconds = -cpu_seconds();
    Sample sum;
    for (long long k = 0; k < steps(o.strain); ++k) {
      Sample sample;
      system->step(k % every == 0 ? &sample : nullptr);
      if (k % every != 0) continue;
      last = sample;
      if (samples++ == 0) first = sample;
      for (int c = 0; c < Sample::count; ++c) sum.value[c] += sample.value[c];
      if (samples % samples_a_window == 0) {
        windows.push_back(sum.value, static_cast<double>(samples_a_window));
        sum = {};
      }
    }
    seconds += cpu_seconds();
  } catch (NumericalError const& error) {
    fmt::print(",,,,,");
    for ([[maybe_unused]] auto const* name : quantities) fmt::print(",,");
    fmt::print("{}\n", error.what());
    return;
  }
  Counts const after = system->counts();
  double const strain = static_cast<double>(steps(o.strain)) * step_strain;
  auto const mean = windows.mean(0, windows.size());
  double const time = static_cast<double>((samples - 1) * every) * method.time_step;
  fmt::print("{:.6g},{:.6g},{:.6g},{:.3g},{:.5f}", strain,
             static_cast<double>(after.searches - before.searches) / strain,
             static_cast<double>(after.damping_passes - before.damping_passes) / strain,
             seconds / strain, energy_gap(mean, first, last, scene.shear.strain_rate, time));
  auto const list = observables(scene, state.box_length);
  for (auto const* name : quantities)
    for (auto const& quantity : list)
      if (quantity.name == name) {
        auto const e = statistics::estimate(windows, 0, quantity.value);
        fmt::print(",{:.6g},{:.3g}", e.mean.value_or(std::numeric_limits<double>::quiet_NaN()),
                   e.error.value_or(std::numeric_limits<double>::quiet_NaN()));
      }
  fmt::print(",ok\n");
}

}  // namespace

void add_steady(CLI::App& app) {
  auto* const command = app.add_subcommand("steady", "averages of the steady state");
  auto const o = std::make_shared<Steady>();
  o->start.add_options(*command);
  command->add_option("--method", o->method, "SCHEME:DT")->capture_default_str();
  command->add_option("--strain", o->strain, "measured")->capture_default_str();
  command->add_option("--discard", o->discard, "strain before that")->capture_default_str();
  command->add_option("--window", o->window, "strain of a window")->capture_default_str();
  command->add_option("--every", o->every, "time between samples, [tau_e]")->capture_default_str();
  command->callback([o] { run(*o); });
}

}  // namespace bagnold::accuracy
