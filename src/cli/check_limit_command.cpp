// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "src/analysis/check_limit.hpp"
#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/sweep_terminal.hpp"
#include "src/config/ladder.hpp"
#include "src/config/schemes.hpp"
#include "src/config/shell_word.hpp"
#include "src/run/rounded.hpp"

namespace bagnold {

namespace {

std::string text_of(analysis::WithError const& one) {
  if (!std::isfinite(one.value)) return "undefined";
  if (!std::isfinite(one.error)) return fmt::format("{:.4g} (no error)", one.value);
  return rounded(one.value, one.error);
}

/// The scheme of the runs, where a longer run would choose another.
std::string kept_scheme(Scene scene, double strain, std::vector<std::string> const& overrides) {
  for (auto const& put : overrides)
    if (put.starts_with("integration.scheme=")) return "";
  auto const scheme = scene.integration.scheme;
  scene.shear.strain = strain;
  return scheme != automatic && auto_is_default(scene)
             ? fmt::format(" --set integration.scheme={}", scheme)
             : "";
}

/// Options of a command that goes on, with its strain or without it.
std::string options_again(CheckLimitOptions const& options, bool with_strain) {
  std::string words;
  for (auto const& put : options.run.overrides)
    if (with_strain || !put.starts_with("shear.strain="))
      words += fmt::format(" --set {}", shell_word(put));
  if (options.tolerance != CheckLimitOptions().tolerance)
    words += fmt::format(" --tolerance {}", options.tolerance);
  if (options.run.allow_unstable) words += " --allow-unstable";
  return words;
}

/// Advice for an undecided limit: the run that would decide, and its command.
std::string advice(analysis::Limit const& limit, CheckLimitOptions const& options,
                   Scene const& scene, std::filesystem::path const& folder) {
  if (limit.verdict != analysis::Verdict::undecided) return {};
  constexpr double most_worth_running = 100, unknown = 1e300;
  bool const known = limit.longer < most_worth_running;
  std::string text;
  if (known)
    text = fmt::format("; about {:.2g} times the strain would tell", limit.longer);
  else if (limit.longer < unknown)
    text =
        "; the change lies so near the tolerance that longer runs alone would hardly tell: take "
        "another --tolerance, or a smaller rate";
  double const strain = scene.shear.strain * std::max(1.5, known ? limit.longer : 4.0);
  return text +
         fmt::format("; `bagnold check-limit {}{}{} --set shear.strain={:.3g} --out {}` goes on",
                     shell_word(options.run.scene_file.string()), options_again(options, false),
                     kept_scheme(scene, strain, options.run.overrides), strain,
                     shell_word(folder.string()));
}

void print(analysis::LimitCheck const& check, CheckLimitOptions const& options, Scene const& scene,
           std::filesystem::path const& folder) {
  double const tolerance = options.tolerance;
  auto const& [runs, rate, measured, found] = check;
  fmt::print("\n{:<10} {:<22} {:<22} {}\n", "quantity", fmt::format("at {:g}", rate),
             fmt::format("at {:g}", rate / 2), "ratio");
  for (auto const& limit : found.limits)
    for (auto const& [name, ratio] : limit.ratios)
      fmt::print("{:<10} {:<22} {:<22} {}\n", name, text_of(measured.at(name).whole),
                 text_of(measured.at(name).half), text_of(ratio));
  for (auto const& [name, exponent] : found.exponents)
    fmt::print("{} ~ gammadot^x, x = {}\n", name, text_of(exponent));
  for (auto const& limit : found.limits) {
    fmt::print("{}'s limit, within {:g}%: {}{}\n", limit.name, 100 * tolerance,
               analysis::word(limit.verdict), advice(limit, options, scene, folder));
  }
  fmt::print("verdict: {}\n", found.verdict());
}

/// Returns 0 whatever the answer.
int check_limit_command(CheckLimitOptions const& options) {
  Scene const scene = read_scene(options.run);
  auto const folder =
      options.run.folder.empty()
          ? std::filesystem::path("results") / (options.run.scene_file.stem().string() + "-limit")
          : options.run.folder;
  catch_signals();
  SweepTerminal terminal(options.run.quiet);
  auto const check = analysis::check_limit(
      scene, folder,
      {options.run.scene_file, options.tolerance, options.run.allow_unstable,
       options_again(options, true), sweep_options(options.run.machine, options.jobs, terminal)});
  if (check.runs == sweep::SweepEnd::done && !options.run.quiet)
    print(check, options, scene, folder);
  return exit_code_of(check.runs);
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
