// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "src/cli/analyse_options.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/exit_code.hpp"
#include "src/run/provenance.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/standard_streams.hpp"
#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/config/shown.hpp"

namespace {

constexpr char const* units =
    "Units: length d_s (small diameter), time tau_e (elastic time), so that k_e = 1; strain\n"
    "rates in 1/tau_e, stresses in m/tau_e^2.\n"
    "Exit codes: 0 done, 1 a sweep with failed points, 2 bad input, 3 numerical failure,\n"
    "4 input/output failure, 5 internal error, 129, 130 or 143 interrupted with a checkpoint\n"
    "written.";

/// Large arrays go back to the system as soon as they are freed: what comes after them needs the room.
void give_back_large_arrays() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 8 << 20);  // small ones need not: they are wanted again
#endif
}

void add_machine(CLI::App& command, bagnold::Machine& machine, bool& quiet) {
  command.add_option("--threads", machine.threads, "threads [default: by count and cores]")
      ->check(CLI::Range(1, 4096));
  command.add_option("--backend", machine.backend, "serial, openmp or cuda [default: by threads]")
      ->check(CLI::IsMember({"serial", "openmp", "cuda"}));
  command.add_flag("--quiet", quiet, "no progress and no table; errors are still shown");
}

void add_scene(CLI::App& command, bagnold::SceneOptions& options) {
  command.add_option("SCENE", options.scene_file, "scene file in TOML (see inputs/reference.toml)")
      ->required();
  command.add_option("--set", options.overrides, "table.key=value, over the scene; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--allow-unstable", options.allow_unstable,
                   "accept a time step (in tau_e) beyond the scheme's stability");
}

void add_sweep(CLI::App& command, bagnold::SweepOptions& options) {
  command.add_option("FILE", options.sweep_file, "scene with a table [sweep] (see inputs/)")
      ->required();
  command.add_option("--out", options.folder, "folder for the points and tables [results/FILE]");
  command.add_option("--jobs", options.jobs, "points at a time [default: cores / threads]")
      ->check(CLI::Range(1, 4096));
  auto* slurm = command.add_flag("--emit-slurm", options.emit_slurm,
                                 "prepare the folder for Slurm and write job scripts; run nothing");
  auto* chain = command.add_option("--chain", options.chain,
                                   "run this chain of points only, from 1, and write no table");
  auto* collect =
      command.add_flag("--collect", options.collect, "write the tables of what is done; run nothing");
  slurm->excludes(chain)->excludes(collect);
  chain->excludes(collect);
  command.add_flag("--allow-unstable", options.allow_unstable,
                   "accept a time step (in tau_e) beyond the scheme's stability");
}

void add_figure(CLI::App& command, bagnold::FigureOptions& options) {
  command.add_option("NAME", options.name, "P2-15: Fig. 15 of P2 (docs/figures.md)");
  command.add_flag("--quick", options.quick, "a small version, of minutes, where there is one");
  command.add_option("--out", options.folder,
                     "folder for pictures, and for data that figures share [results/figures]");
  command.add_option("--data", options.data,
                     "draw from the tables in this folder, docs/data/figures; run nothing");
  command.add_option("--figures", options.figures, "file of figures [inputs/figures/figures.toml]");
  command.add_option("--jobs", options.jobs, "runs at a time [default: cores]")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--quiet", options.quiet, "no progress and no table; errors are still shown");
}

/// The words of the command line, the first one last, as CLI11 wants them; `help COMMAND` becomes
/// `COMMAND --help`.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    words.emplace_back("--help");
  }
  std::ranges::reverse(words);
  return words;
}

/// CLI11 would complain of the words behind it.
void refuse_unknown_command(CLI::App const& app, std::vector<std::string> const& words) {
  if (words.empty() || words.back().starts_with("-")) return;
  std::vector<std::string> names;
  for (auto const* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::count(names, words.back()) == 0)
    throw bagnold::InputError(fmt::format("unknown command {}; did you mean {}? See bagnold --help",
                                          bagnold::shown(words.back()),
                                          bagnold::nearest_word(words.back(), names)));
}

int run(int argc, char** argv) {
  CLI::App app("Bagnold: dense granular flow of soft disks at vanishing shear rate");
  app.footer(units);
  app.require_subcommand(1);
  app.set_version_flag("--version", [] {
    auto const made = bagnold::provenance();
    return fmt::format("bagnold {} ({})", made.version, made.git);
  });

  bagnold::SceneOptions run;
  auto* run_command = app.add_subcommand("run", "run a scene");
  run_command->footer(units);
  add_scene(*run_command, run);
  run_command->add_option("--out", run.folder, "folder for the results [results/SCENE]")
      ->check([](std::string const& name) { return std::string(name.empty() ? "is empty" : ""); });
  run_command->add_flag("--force", run.force, "replace the run that is in the folder");
  add_machine(*run_command, run.machine, run.quiet);

  bagnold::SceneOptions validate;
  auto* validate_command =
      app.add_subcommand("validate", "check a scene; print it resolved, its steps, memory and time");
  validate_command->footer(units);
  add_scene(*validate_command, validate);

  bagnold::ResumeOptions resume;
  auto* resume_command =
      app.add_subcommand("resume", "go on with an interrupted run, bit for bit");
  resume_command->footer(units);
  resume_command->add_option("DIR", resume.folder, "folder of the run")->required();
  add_machine(*resume_command, resume.machine, resume.quiet);

  bagnold::SweepOptions sweep;
  auto* sweep_command =
      app.add_subcommand("sweep", "run all points of a sweep file; the same command goes on with it");
  sweep_command->footer(units);
  add_sweep(*sweep_command, sweep);
  add_machine(*sweep_command, sweep.machine, sweep.quiet);

  bagnold::AnalyseOptions analyse;
  auto* analyse_command = app.add_subcommand("analyse", "fits and phase boundaries from a sweep");
  bagnold::add_analyse_options(*analyse_command, analyse);

  bagnold::CheckLimitOptions limit;
  auto* limit_command = app.add_subcommand(
      "check-limit", "is the rate small enough? The scene at its rate and at half of it, compared");
  limit_command->footer(units);
  add_scene(*limit_command, limit.run);
  limit_command->add_option("--out", limit.run.folder, "folder for both runs [results/SCENE-limit]");
  limit_command->add_option("--jobs", limit.jobs, "runs at a time [default: cores / threads]")
      ->check(CLI::Range(1, 4096));
  limit_command->add_option("--tolerance", limit.tolerance, "relative change that counts as none [0.05]")
      ->check(CLI::Range(1e-6, 0.3));
  add_machine(*limit_command, limit.run.machine, limit.run.quiet);

  bagnold::FigureOptions figure;
  auto* figure_command = app.add_subcommand(
      "figure", "run and draw a figure of the papers; without a name: list them");
  figure_command->footer(units);
  add_figure(*figure_command, figure);

  auto* info_command = app.add_subcommand("info", "version, git hash, Kokkos, backends, CPU");
  info_command->footer(units);

  auto const words = words_of(argc, argv);
  refuse_unknown_command(app, words);
  try {
    app.parse(std::vector(words));
  } catch (CLI::ParseError const& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw bagnold::InputError(fmt::format("{}; see bagnold --help", error.what()));
  }
  if (*run_command) return bagnold::run_command(run);
  if (*validate_command) return bagnold::validate_command(validate);
  if (*resume_command) return bagnold::resume_command(resume);
  if (*sweep_command) return bagnold::sweep_command(sweep);
  if (*analyse_command) return bagnold::analyse_command(analyse);
  if (*limit_command) return bagnold::check_limit_command(limit);
  if (*figure_command) return bagnold::figure_command(figure);
  return bagnold::info_command();
}

}  // namespace

int main(int argc, char** argv) {
  bagnold::catch_checkpoint_signal();
  bagnold::open_standard_streams();
  give_back_large_arrays();
  int code = bagnold::internal_error;
  try {
    code = run(argc, argv);
  } catch (...) {
    code = bagnold::exit_code_of(std::current_exception());
  }
  auto const unwritten = bagnold::finish_output();
  if (code != bagnold::done || unwritten.empty()) return code;
  bagnold::say(unwritten);
  return bagnold::file_failure;
}
