// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/check_limit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/atomic_file.hpp"
#include "src/sweep/checked_sweep.hpp"
#include "src/sweep/placed_points.hpp"

namespace bagnold::analysis {

namespace {

using Json = nlohmann::ordered_json;

constexpr char const* compared_names[] = {"B_p", "B_sigma", "eta_p", "eta_sigma", "p", "sigma"};

sweep::Sweep both_rates(Scene const& scene, LimitRequest const& request) {
  auto const origin = request.scene_file.string();
  if (!scene.shear.rate_stays() || scene.shear.run_per_rate())
    throw InputError(
        fmt::format("{}: shear.protocol = \"{}\" (must be \"steady\": a limit is checked at one "
                    "rate); make a scene of the rate in question",
                    origin, scene.shear.protocol));
  double const rate = scene.shear.strain_rate;
  auto const text = fmt::format("{}\n[sweep]\ngrid = {{ \"shear.strain_rate\" = [{}, {}] }}\n",
                                write_scene(scene), rate, rate / 2);
  auto both =
      sweep::parse_sweep(text, origin, std::filesystem::absolute(request.scene_file).parent_path(),
                         sweep::point_check(request.allow_unstable));
  both.command = "check-limit";
  both.options = request.options;
  return both;
}

/// Means and errors of a run, by name. An error of 0 counts as unknown: nothing happened in the
/// run.
std::map<std::string, WithError> summary_of(std::filesystem::path const& point) try {
  auto const bytes = io::read_file(point / "summary.json");
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  auto const number = [](Json const& json, double none) {
    return json.is_number() ? json.get<double>() : none;
  };
  std::map<std::string, WithError> found;
  Json const observables = Json::parse(text, text + bytes.size()).at("observables");
  for (auto const* name : compared_names) {
    Json const& one = observables.at(name);
    double const error = number(one.at("error"), INFINITY);
    found[name] = {number(one.at("mean"), std::nan("")), error > 0 ? error : INFINITY};
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

Json json_of(RateLimit const& found, double rate, double tolerance) {
  Json json{{"schema", 1},
            {"verdict", found.verdict()},
            {"strain_rates", {rate, rate / 2}},
            {"tolerance", tolerance}};
  for (auto const& limit : found.limits) {
    Json& one = json["limits"][limit.name];
    one["verdict"] = word(limit.verdict);
    for (auto const& [name, ratio] : limit.ratios) one["ratios"][name] = json_of(ratio);
  }
  for (auto const& [name, exponent] : found.exponents) json["exponents"][name] = json_of(exponent);
  return json;
}

}  // namespace

LimitCheck check_limit(Scene const& scene, std::filesystem::path const& folder,
                       LimitRequest const& request) {
  auto const asked = both_rates(scene, request);
  LimitCheck check{sweep::run(asked, folder, request.runs), scene.shear.strain_rate, {}, {}};
  if (check.runs != sweep::SweepEnd::done) return check;
  auto const sweep = sweep::place_points(asked, folder).sweep;
  auto const whole = summary_of(folder / "points" / sweep.points.at(0).folder);
  auto const half = summary_of(folder / "points" / sweep.points.at(1).folder);
  for (auto const* name : compared_names) check.measured[name] = {whole.at(name), half.at(name)};
  check.found = rate_limit(check.measured, request.tolerance);
  io::replace_text(folder / "check_limit.json",
                   json_of(check.found, check.strain_rate, request.tolerance).dump(2) + "\n");
  return check;
}

}  // namespace bagnold::analysis
