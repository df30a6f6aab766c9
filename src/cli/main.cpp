// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <new>

#include "src/cli/commands.hpp"
#include "src/cli/name_value.hpp"
#include "src/config/errors.hpp"

namespace {

constexpr char const* units =
    "Units: length d_s (small diameter), time tau_e (elastic time), so that k_e = 1; strain rates in\n"
    "1/tau_e, stresses in m/tau_e^2.\n"
    "Exit codes: 0 done, 2 bad input, 3 numerical failure, 4 input/output failure, 130 or 143\n"
    "interrupted with a checkpoint written.";

enum ExitCode { done = 0, bad_input = 2, numerical_failure = 3, file_failure = 4 };

int say(char const* message, ExitCode code) {
  fmt::print(stderr, "bagnold: {}\n", message);
  return code;
}

void add_machine(CLI::App& command, bagnold::Machine& machine, bool& quiet) {
  command.add_option("--threads", machine.threads, "threads [default: by count and cores]")
      ->check(CLI::Range(1, 4096));
  command.add_option("--backend", machine.backend, "serial, openmp or cuda [default: by threads]")
      ->check(CLI::IsMember({"serial", "openmp", "cuda"}));
  command.add_flag("--quiet", quiet, "no progress and no table; errors are still shown");
}

void add_scene(CLI::App& command, bagnold::RunOptions& options) {
  command.add_option("SCENE", options.scene_file, "scene file in TOML (see inputs/reference.toml)")
      ->required();
  command.add_option("--set", options.overrides, "table.key=value, over the scene; may be repeated")
      ->allow_extra_args(false);
  command.add_flag("--allow-unstable", options.allow_unstable,
                   "accept a time step (in tau_e) beyond the scheme's stability");
}

void add_axes(CLI::App& command, bagnold::analysis::Request& request) {
  command.add_option("--x", request.x, "quantity to the right: a key, an observable, phi_J-phi, A/B");
  command.add_option("--y", request.y, "quantity upwards");
  command.add_option("--along", request.along, "key that runs along a curve [x, or phi]");
  command.add_option("--by", request.by, "keys that tell curves apart [all others that vary]");
  command.add_option_function<std::vector<std::string>>(
             "--where",
             [&](auto const& pairs) { request.where = bagnold::name_values(pairs, "--where"); },
             "KEY=VALUE: only these points; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--range", request.range, "LOW HIGH: only x between");
  command.add_flag("--log-x", request.log_x, "straight lines in ln x (kink, transition)");
  command.add_flag("--log-y", request.log_y, "straight lines in ln y (kink, transition)");
}

void add_fit(CLI::App& command, bagnold::analysis::Request& request) {
  command.add_option("--phi-j", request.phi_j, "phi_J: fixed in a divergence, used by phi_J-phi");
  command.add_option_function<std::vector<std::string>>(
             "--fix",
             [&](auto const& pairs) { request.fixed = bagnold::name_numbers(pairs, "--fix"); },
             "NAME=VALUE: a parameter that is not fitted; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--of", request.of, "divergence: crossover, jump, transition or value");
  command.add_option("--kinks", request.kinks, "kink: 1 or 2 [1]");
  command.add_option("--direction", request.direction, "jump: up, down or both [both]");
  command.add_option("--least-factor", request.least_factor, "jump: by which y changes at least [2]")
      ->check(CLI::Range(1.0, 1e12));
  command.add_option("--rates", request.rates, "transition: two strain rates [the smallest two]")
      ->expected(2);
  command.add_option("--split", request.split, "transition: x between the two lines [best fit]");
  command.add_option("--pressure", request.pressure, "constant-pressure: P, [m/tau_e^2]");
  command.add_option("--window", request.window, "exponents: points a slope is taken over [3]");
  command.add_option("--resamples", request.resamples, "of the bootstrap; 0: none [400]")
      ->check(CLI::Range(0, 100000));
  command.add_option("--seed", request.seed, "of the bootstrap [1]");
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Bagnold: dense granular flow of soft disks at vanishing shear rate");
  app.footer(units);
  app.require_subcommand(1);

  bagnold::RunOptions run;
  auto* run_command = app.add_subcommand("run", "run a scene");
  run_command->footer(units);
  add_scene(*run_command, run);
  run_command->add_option("--out", run.folder, "folder for the results [results/SCENE]")
      ->check([](std::string const& name) { return std::string(name.empty() ? "is empty" : ""); });
  run_command->add_flag("--force", run.force, "replace the run that is in the folder");
  add_machine(*run_command, run.machine, run.quiet);

  bagnold::RunOptions validate;
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

  bagnold::AnalyseOptions analyse;
  auto* analyse_command = app.add_subcommand("analyse", "fits and phase boundaries from a sweep");
  analyse_command->footer(bagnold::analyse_kinds());
  analyse_command->add_option("KIND", analyse.kind, "what to find, see below")->required();
  analyse_command->add_option("SWEEP", analyse.sweep, "folder of a sweep, or sweep.h5")->required();
  analyse_command->add_option("--out", analyse.prefix, "prefix of the files written [SWEEP/KIND]");
  add_axes(*analyse_command, analyse.request);
  add_fit(*analyse_command, analyse.request);
  analyse_command->add_flag("--quiet", analyse.quiet, "no table; errors and remarks are still shown");

  auto* info_command = app.add_subcommand("info", "version, git hash, Kokkos, backends, CPU");
  info_command->footer(units);

  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return say(fmt::format("{}; see bagnold --help", error.what()).c_str(), bad_input);
  }
  if (*run_command) return bagnold::run_command(run);
  if (*validate_command) return bagnold::validate_command(validate);
  if (*resume_command) return bagnold::resume_command(resume);
  if (*analyse_command) return bagnold::analyse_command(analyse);
  if (*info_command) return bagnold::info_command();
  return bad_input;
} catch (bagnold::InputError const& error) {
  return say(error.what(), bad_input);
} catch (bagnold::NumericalError const& error) {
  return say(error.what(), numerical_failure);
} catch (bagnold::FileError const& error) {
  return say(error.what(), file_failure);
} catch (std::bad_alloc const&) {
  return say("out of memory; use fewer disks or a machine with more", bad_input);
} catch (std::exception const& error) {
  return say(error.what(), file_failure);
}
