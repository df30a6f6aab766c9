// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/run_results.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/cli/provenance.hpp"
#include "src/config/keys.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/result_file.hpp"

namespace bagnold {

namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> const& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json scene_json(Scene const& scene) {
  Json all = Json::object();
  for_each_key(scene, [&](Key const& key, auto const& member) {
    Json value;
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, std::optional<double>>)
      value = number(member);
    else
      value = member;
    auto const dot = key.name.find('.');
    if (dot == std::string_view::npos)
      all[std::string(key.name)] = value;
    else
      all[std::string(key.name.substr(0, dot))][std::string(key.name.substr(dot + 1))] = value;
  });
  return all;
}

double step_strain(Run const& run) { return run.plan.time_step * run.scene.shear.strain_rate; }

/// Strain at the end of a window.
double strain_at_end(Run const& run, std::size_t window) {
  auto const end = std::min(static_cast<std::int64_t>(window + 1) * run.plan.window_steps,
                            run.plan.steps);
  return step_strain(run) * static_cast<double>(end);
}

std::size_t discarded(Run const& run) {
  return std::min(static_cast<std::size_t>(run.plan.discarded_windows),
                  run.measurement.windows.size());
}

}  // namespace

std::vector<NamedEstimate> estimates(Run const& run) {
  std::vector<NamedEstimate> list;
  for (auto const& observable : observables(run.scene, run.box_length))
    list.push_back({observable, statistics::estimate(run.measurement.windows, discarded(run),
                                                     observable.value)});
  return list;
}

void write_result_file(RunFolder const& folder, Run const& run) {
  auto const& windows = run.measurement.windows;
  io::Result result;
  Provenance const made = provenance();
  auto const& disks = run.scene.disks;
  result.attributes = {{"title", run.scene.title},
                       {"bagnold_version", made.version},
                       {"git", made.git},
                       {"compiler", made.compiler},
                       {"kokkos", made.kokkos},
                       {"backend", run.backend},
                       {"scene", write_scene(run.scene)},
                       {"model", disks.model},
                       {"mass", disks.mass},
                       {"count", disks.count},
                       {"packing_fraction", disks.packing_fraction},
                       {"elasticity", disks.elasticity},
                       {"strain_rate", run.scene.shear.strain_rate},
                       {"seed", disks.seed},
                       {"box_length", run.box_length},
                       {"time_step", run.plan.time_step},
                       {"steps", run.plan.steps},
                       {"window_steps", run.plan.window_steps}};
  for (auto const& [name, value] : run.start_record) result.attributes.push_back({name, value});
  for (auto const& [name, value] : run.engine) result.attributes.push_back({"engine_" + name, value});
  result.discarded_windows = static_cast<std::int64_t>(discarded(run));

  io::Series strain{"strain", "1", "at the end of the window, from 0 at the start", {}};
  io::Series time{"time", "tau_e", "at the end of the window", {}};
  io::Series rate{"strain_rate", "1/tau_e", "gammadot", {}};
  for (std::size_t w = 0; w < windows.size(); ++w) {
    strain.value.push_back(strain_at_end(run, w));
    time.value.push_back(run.initial_time + strain.value.back() / run.scene.shear.strain_rate);
    rate.value.push_back(run.scene.shear.strain_rate);
  }
  io::Series weight{"evaluations", "1", "configurations evaluated in the window", windows.weight};
  result.series = {strain, time, rate, weight};

  for (auto const& observable : observables(run.scene, run.box_length)) {
    io::Series series{std::string(observable.name), std::string(observable.unit),
                      std::string(observable.meaning), {}};
    for (std::size_t w = 0; w < windows.size(); ++w)
      series.value.push_back(observable.value(windows.mean(w, w + 1)));
    result.series.push_back(std::move(series));
  }
  auto found = run.measurement.frames.results();
  result.histograms = std::move(found.histograms);
  result.profiles = std::move(found.profiles);
  result.samples = std::move(found.samples);
  io::write_result(folder.result(), result);
}

void write_summary(RunFolder const& folder, Run const& run,
                   std::vector<NamedEstimate> const& list) {
  Provenance const made = provenance();
  auto const& windows = run.measurement.windows;
  double const total = step_strain(run) * static_cast<double>(run.plan.steps);
  double const first =
      discarded(run) == 0 ? 0.0 : strain_at_end(run, discarded(run) - 1);
  double const disk_steps =
      static_cast<double>(run.plan.steps) * static_cast<double>(run.scene.disks.count);

  Json summary;
  summary["schema"] = 1;
  summary["bagnold"] = {{"version", made.version}, {"git", made.git}};
  summary["scene"] = scene_json(run.scene);
  summary["strain"] = {{"total", total}, {"measured", total - first}};
  summary["steps"] = run.plan.steps;
  summary["wall_seconds"] = run.wall_seconds;
  summary["disk_steps_per_second"] =
      number(run.wall_seconds > 0 ? disk_steps / run.wall_seconds
                                  : std::numeric_limits<double>::quiet_NaN());
  double const window_strain = step_strain(run) * static_cast<double>(run.plan.window_steps);
  auto const put = [&](std::string const& name, statistics::Estimate const& estimate,
                       double strain_between) {
    auto const& tau = estimate.correlation;
    summary["observables"][name] = {
        {"mean", number(estimate.mean)},
        {"error", number(estimate.error)},
        {"correlation_strain", tau ? number(*tau * strain_between) : Json(nullptr)},
        {"samples", estimate.samples}};
  };
  for (auto const& [observable, estimate] : list)
    put(std::string(observable.name), estimate, window_strain);
  double const frame_strain = step_strain(run) * static_cast<double>(run.plan.frame_steps);
  for (auto const& scalar : run.measurement.frames.results().scalars)
    put(scalar.name, scalar.estimate, frame_strain);
  RunFolder::write_text(folder.summary(), summary.dump(2) + "\n");
}

}  // namespace bagnold
