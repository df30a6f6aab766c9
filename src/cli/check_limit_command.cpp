// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "src/analysis/rate_limit.hpp"
#include "src/cli/checked_sweep.hpp"
#include "src/cli/options.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold {

namespace {

namespace fs = std::filesystem;
using analysis::AtTwoRates;
using analysis::WithError;
using Json = nlohmann::ordered_json;

constexpr char const* compared[] = {"B_p", "B_sigma", "eta_p", "eta_sigma", "p", "sigma"};

sweep::Sweep both_rates(Scene const& scene, SceneOptions const& options) {
  if (scene.shear.protocol != "steady")
    throw InputError(
        fmt::format("{}: shear.protocol = \"{}\" (must be \"steady\": a limit is checked at one "
                    "rate); make a scene of the rate in question",
                    options.scene_file.string(), scene.shear.protocol));
  double const rate = scene.shear.strain_rate;
  auto const text = fmt::format("{}\n[sweep]\ngrid = {{ \"shear.strain_rate\" = [{}, {}] }}\n",
                                write_scene(scene), rate, rate / 2);
  return sweep::parse_sweep(text, options.scene_file.string(),
                            fs::absolute(options.scene_file).parent_path(),
                            point_check(options.allow_unstable));
}

using Averages = std::map<std::string, WithError>;

/// What a run found, by name.
Averages summary_of(fs::path const& point) try {
  auto const bytes = io::read_file(point / "summary.json");
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  auto const number = [](Json const& json, double none) {
    return json.is_number() ? json.get<double>() : none;
  };
  Averages found;
  Json const observables = Json::parse(text, text + bytes.size()).at("observables");
  for (auto const* name : compared) {
    Json const& one = observables.at(name);
    found[name] = {number(one.at("mean"), std::nan("")), number(one.at("error"), INFINITY)};
  }
  return found;
} catch (Json::exception const& error) {
  throw FileError(fmt::format("{}: is damaged ({}); remove {} to run it again",
                              (point / "summary.json").string(), error.what(), point.string()));
}

Json json_of(WithError const& one) {
  auto const number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  return {{"value", number(one.value)}, {"error", number(one.error)}};
}

Json json_of(analysis::RateLimit const& found, double rate, double tolerance) {
  Json json{{"schema", 1},
            {"verdict", found.verdict()},
            {"strain_rates", {rate, rate / 2}},
            {"tolerance", tolerance}};
  for (auto const& limit : found.limits) {
    Json& one = json["limits"][limit.name];
    one["verdict"] = analysis::word(limit.verdict);
    for (auto const& [name, ratio] : limit.ratios) one["ratios"][name] = json_of(ratio);
  }
  for (auto const& [name, exponent] : found.exponents) json["exponents"][name] = json_of(exponent);
  return json;
}

std::string text_of(WithError const& one) {
  if (!std::isfinite(one.value)) return "undefined";
  if (!std::isfinite(one.error)) return fmt::format("{:.4g} (no error)", one.value);
  return fmt::format("{:.4g} +- {:.1g}", one.value, one.error);
}

void print(analysis::RateLimit const& found, std::map<std::string, AtTwoRates> const& measured,
           double rate, double tolerance) {
  fmt::print("\n{:<10} {:<22} {:<22} {}\n", "quantity", fmt::format("at {:g}", rate),
             fmt::format("at {:g}", rate / 2), "ratio");
  for (auto const& limit : found.limits)
    for (auto const& [name, ratio] : limit.ratios)
      fmt::print("{:<10} {:<22} {:<22} {}\n", name, text_of(measured.at(name).whole),
                 text_of(measured.at(name).half), text_of(ratio));
  for (auto const& [name, exponent] : found.exponents)
    fmt::print("{} ~ gammadot^x, x = {}\n", name, text_of(exponent));
  for (auto const& limit : found.limits) {
    auto longer = limit.longer < 1e6
                      ? fmt::format("; about {:.2g} times the strain would tell", limit.longer)
                      : std::string("; raise shear.strain");
    if (limit.verdict != analysis::Verdict::undecided) longer.clear();
    fmt::print("{}'s limit, within {:g}%: {}{}\n", limit.name, 100 * tolerance,
               analysis::word(limit.verdict), longer);
  }
  fmt::print("verdict: {}\n", found.verdict());
}

/// Whether a scene's rate is in a limit (src/analysis/rate_limit.hpp): runs it at its rate and at
/// half of it, as a sweep that goes on where it stopped, and writes check_limit.json. 0 whatever
/// the answer.
int check_limit_command(CheckLimitOptions const& options) {
  Scene const scene = read_scene(options.run);
  auto const sweep = both_rates(scene, options.run);
  SweepOptions points;
  points.sweep_file = options.run.scene_file;
  points.folder = options.run.folder.empty()
                      ? fs::path("results") / (options.run.scene_file.stem().string() + "-limit")
                      : options.run.folder;
  points.machine = options.run.machine;
  points.jobs = options.jobs;
  points.quiet = options.run.quiet;
  points.allow_unstable = options.run.allow_unstable;
  if (int const code = run_sweep(sweep, points); code != 0) return code;

  auto const folder = points.folder / "points";
  auto const whole = summary_of(folder / sweep.points.at(0).folder);
  auto const half = summary_of(folder / sweep.points.at(1).folder);
  std::map<std::string, AtTwoRates> found;
  for (auto const* name : compared) found[name] = {whole.at(name), half.at(name)};
  auto const limit = analysis::rate_limit(found, options.tolerance);
  io::replace_text(points.folder / "check_limit.json",
                   json_of(limit, scene.shear.strain_rate, options.tolerance).dump(2) + "\n");
  if (!options.run.quiet) print(limit, found, scene.shear.strain_rate, options.tolerance);
  return 0;
}

}  // namespace

Command add_check_limit(Words program) {
  auto const options = std::make_shared<CheckLimitOptions>();
  Words command =
      add_command(program, "check-limit",
                  "is the rate small enough? The scene at its rate and at half of it, compared");
  add_scene_options(command, options->run);
  command.option("--out", options->run.folder, "folder for both runs [results/SCENE-limit]");
  command.option("--jobs", options->jobs, "runs at a time [default: cores / threads]")
      .between(1, 4096);
  command.option("--tolerance", options->tolerance, "relative change that counts as none [0.05]")
      .between(1e-6, 0.3);
  add_machine_options(command, options->run.machine, options->run.quiet);
  return {command, [options] { return check_limit_command(*options); }};
}

}  // namespace bagnold
