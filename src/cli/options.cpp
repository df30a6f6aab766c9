// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/options.hpp"

namespace bagnold {

char const* const units_and_exit_codes =
    "Units: length d_s (small diameter), time tau_e (elastic time), so that k_e = 1; strain\n"
    "rates in 1/tau_e, stresses in m/tau_e^2.\n"
    "Exit codes: 0 done, 1 a sweep with failed points, 2 bad input, 3 numerical failure,\n"
    "4 input/output failure, 5 internal error, 129, 130 or 143 interrupted with a checkpoint\n"
    "written.";

CLI::App& add_command(CLI::App& program, char const* name, char const* description) {
  CLI::App& command = *program.add_subcommand(name, description);
  command.footer(units_and_exit_codes);
  return command;
}

void add_machine_options(CLI::App& command, Machine& machine, bool& quiet) {
  command.add_option("--threads", machine.threads, "threads [default: by count and cores]")
      ->check(CLI::Range(1, 4096));
  command.add_option("--backend", machine.backend, "serial, openmp or cuda [default: by threads]")
      ->check(CLI::IsMember({"serial", "openmp", "cuda"}));
  command.add_flag("--quiet", quiet, "no progress and no table; errors are still shown");
}

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("SCENE", options.scene_file, "scene file in TOML (see inputs/reference.toml)")
      ->required();
  command
      .add_option("--set", options.overrides, "table.key=value, over the scene; may be repeated")
      ->allow_extra_args(false);
  add_unstable_flag(command, options.allow_unstable);
}

void add_unstable_flag(CLI::App& command, bool& allow_unstable) {
  command.add_flag("--allow-unstable", allow_unstable,
                   "accept a time step (in tau_e) beyond the scheme's stability");
}

}  // namespace bagnold
