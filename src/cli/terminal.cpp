// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/terminal.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "src/cli/signals.hpp"
#include "src/cli/standard_streams.hpp"
#include "src/cli/table.hpp"
#include "src/run/messages.hpp"
#include "src/run/protocols/cascade/cascade.hpp"

namespace bagnold {

namespace {

/// Folder of the run that can be made longer: for the last rate of a cascade the cascade's; "" for
/// its earlier rates.
std::string growing_folder(RunFolder const& folder, std::optional<StageFolder> const& stage) {
  if (!stage) return folder.path().string();
  return stage->is_last() ? stage->cascade.string() : "";
}

/// Strains of all rates of a cascade, that of one as "bagnold resume DIR --strain X" says.
std::vector<std::string> longer_strains(StageFolder const& stage, std::string const& command) {
  auto const& shear = stage.scene.shear;
  std::vector<std::string> strains;
  for (std::size_t k = 0; k < shear.strain_rates.size(); ++k)
    strains.push_back(fmt::format("{}", shear.strain.at(k)));
  strains[stage.stage] = command.substr(command.rfind(' ') + 1);
  return strains;
}

/// Warning with a command that is right for a rate of a cascade: the cascade is made longer, not
/// the rate.
Warning with_command(Warning warning, std::optional<StageFolder> const& stage) {
  if (!stage || !warning.command.starts_with("bagnold resume")) return warning;
  if (stage->is_last())
    warning.command = with_folder(warning.command, stage->cascade.string());
  else
    warning.command = fmt::format(
        "bagnold run {0}/scene.toml --set 'shear.strain=[{1}]' --out {0}-longer",
        stage->cascade.string(), fmt::join(longer_strains(*stage, warning.command), ", "));
  return warning;
}

}  // namespace

bool Terminal::stop_requested() { return stop_signal() != 0; }

bool Terminal::checkpoint_requested() { return bagnold::checkpoint_requested(); }

void Terminal::status(std::string const& text) {
  if (!quiet_) put(text + "\n");
}

void Terminal::begin(Scene const& scene, Plan const& plan, std::int64_t steps) {
  progress_.emplace(scene, plan, steps, quiet_, part_);
}

void Terminal::finished(RunFolder const& folder, FinishedRun const& run,
                        std::vector<Warning> const& suspect) {
  if (quiet_) return;
  auto const stage = stage_folder_in_cascade(folder.path());
  print_table(run.run, run.found, growing_folder(folder, stage), all_);
  fmt::print("\nresults in {}\n", folder.path().string());
  std::fflush(stdout);  // before stderr
  for (auto const& warning : suspect) {
    auto const text = text_of(with_command(warning, stage), folder.path().string());
    warning.is_note ? say("note: " + text) : warn(text);
  }
}

}  // namespace bagnold
