// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "src/config/oscillation.hpp"
#include "src/config/shell_word.hpp"
#include "src/run/make_longer.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

NamedEstimate const* FinishedRun::of(std::string_view name) const {
  auto const at =
      std::ranges::find(found, name, [](NamedEstimate const& one) { return one.observable.name; });
  return at == found.end() ? nullptr : &*at;
}

double FinishedRun::mean(std::string_view name) const {
  auto const* estimate = of(name);
  return estimate && estimate->estimate.all.mean ? *estimate->estimate.all.mean
                                                 : std::numeric_limits<double>::quiet_NaN();
}

double FinishedRun::measured_strain() const {
  return path_of(run, static_cast<std::size_t>(run.plan.windows)) -
         path_of(run, static_cast<std::size_t>(run.plan.discarded_windows));
}

double FinishedRun::box_area() const {
  if (!run.scene.shear.changes_box()) return run.box_area();
  return run.box_area() * run.scene.disks.packing_fraction / mean("packing_fraction");
}

double FinishedRun::in_window(std::string_view name, std::size_t window) const {
  auto const& [observable, samples] = static_cast<SampledObservable const&>(*of(name));
  double sum = 0;
  for (auto const* of_replica : samples)
    sum += observable.value(of_replica->mean(window, window + 1));
  return sum / static_cast<double>(samples.size());
}

namespace {

std::span<Check* const> checks_of(Scene::Shear const& shear) {
  if (shear.finds_rate()) return checks_at_stress;
  if (shear.changes_box()) return checks_at_pressure;
  if (shear.by_pieces()) return checks_of_pieces;
  return all_checks;
}

/// The run's scene with other values, in a folder of its own.
std::string run_with(std::string_view values, std::string_view suffix) {
  return fmt::format("bagnold run DIR/scene.toml {} --out DIR-{}", values, suffix);
}

}  // namespace

namespace {

/// A length rounded up to two digits.
std::string two_digits(double length) {
  double const unit = std::pow(10, std::floor(std::log10(length)) - 1);
  return fmt::format("{:.6g}", unit * std::ceil(length / unit - 1e-9));
}

}  // namespace

std::vector<Warning> warnings(FinishedRun const& finished) {
  std::vector<Warning> list;
  for (auto* check : checks_of(finished.run.scene.shear))
    if (auto warning = check(finished)) list.push_back(std::move(*warning));
  return list;
}

std::string by_scheme(std::string_view scheme, std::string_view suffix) {
  return run_with(
      fmt::format("--set integration.scheme={} --set integration.time_step=auto", scheme), suffix);
}

bool is_held(statistics::Estimate const& found, double wanted) {
  constexpr double most = 0.05, most_without_error = 0.2;
  double const off = std::abs(*found.mean - wanted);
  return off <= (found.error ? most * wanted + standard_errors * *found.error
                             : most_without_error * wanted);
}

std::string given_step(Run const& run, double time_step, int digits) {
  auto const& shear = run.scene.shear;
  if (!shear.ramps() && !shear.oscillates()) return fmt::format("{:.{}g}", time_step, digits);
  double const piece =
      shear.ramps() ? shear.ramp_every
                    : oscillation_period(run.scene) / static_cast<double>(shear.cycle_pieces);
  return fmt::format("{}", piece / std::ceil(piece / time_step * (1 - 1e-12)));
}

std::string half_the_step(FinishedRun const& finished) {
  return changed_run("integration.time_step",
                     given_step(finished.run, finished.run.plan.time_step / 2, 6));
}

std::string with_folder(std::string text, std::string const& name) {
  auto const folder = shell_word(name);
  for (auto at = text.find("DIR"); at != std::string::npos; at = text.find("DIR", at)) {
    text.replace(at, 3, folder);
    at += folder.size();
  }
  return text;
}

std::string text_of(Warning const& warning, std::string const& folder) {
  auto const text = fmt::format("{}: {}; {}", warning.name, warning.reason, warning.remedy);
  if (warning.command.empty()) return text;
  return fmt::format("{}: `{}`", text, with_folder(warning.command, folder));
}

std::string longer_run(Run const& run, double times) {
  auto const& shear = run.scene.shear;
  if (run.target_met && !shear.target_error.empty())  // where it ends, more strain changes nothing
    return run_with(
        fmt::format("--set 'shear.target_error={{}}' --set shear.strain={}",
                    two_digits(run.plan.strain(run.plan.steps) * std::clamp(times, 1.5, 1e3))),
        "longer");
  double const least = run.plan.by_time ? 1.5 : std::max(1.5, least_lengthening(run.scene));
  double const length = (run.plan.by_time ? shear.time : double{shear.strain}) *
                        std::clamp(times, least, std::max(least, 1e3));
  auto const longer = two_digits(length);
  return run.plan.by_time ? changed_run("shear.time", longer)
                          : "bagnold resume DIR --strain " + longer;
}

double fewest_independent_windows(FinishedRun const& finished) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& named : finished.found)
    if (auto const& one = named.estimate.all; !one.remark.empty() && one.independent > 0)
      least = std::min(least, one.independent);
  return least;
}

std::string until_errors(FinishedRun const& finished) {
  double const least = fewest_independent_windows(finished);
  constexpr double share_seen = 1 / 1.5;  // a short series shows too many
  if (!std::isfinite(least) || !finished.run.scene.shear.has_one_flow()) return {};
  return longer_run(finished.run, enough_windows / (share_seen * least));
}

std::string changed_run(std::string const& key, std::string const& value) {
  return run_with(fmt::format("--set {}={}", key, value), key.substr(key.find('.') + 1));
}

}  // namespace bagnold
