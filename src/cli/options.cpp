// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/options.hpp"

namespace bagnold {

char const* const units_and_exit_codes =
    "Units: length d_s (small diameter), time tau_e (elastic time), so that k_e = 1; strain\n"
    "rates in 1/tau_e, stresses in m/tau_e^2.\n"
    "Exit codes: 0 done, 1 a sweep with failed points, 2 bad input, 3 numerical failure,\n"
    "4 input/output failure, 5 internal error, 129, 130 or 143 interrupted with a checkpoint\n"
    "written.";

Words add_command(Words program, char const* name, char const* description) {
  Words command = program.command(name, description);
  command.footer(units_and_exit_codes);
  return command;
}

void add_machine_options(Words command, Machine& machine, bool& quiet) {
  command.option("--threads", machine.threads, "threads [default: by count and cores]")
      .between(1, 4096);
  command.option("--backend", machine.backend, "serial, openmp or cuda [default: by threads]")
      .one_of({"serial", "openmp", "cuda"});
  command.flag("--quiet", quiet, "no progress and no table; errors are still shown");
}

void add_scene_options(Words command, SceneOptions& options) {
  command.option("SCENE", options.scene_file, "scene file in TOML (see inputs/reference.toml)")
      .required();
  command.option("--set", options.overrides, "table.key=value, over the scene; may be repeated")
      .one_value_each();
  add_unstable_flag(command, options.allow_unstable);
}

void add_picture_format(Words command, std::string& format) {
  command.option("--format", format, "of the picture: png, pdf or svg [png]")
      .one_of({"png", "pdf", "svg"});
}

void add_unstable_flag(Words command, bool& allow_unstable) {
  command.flag("--allow-unstable", allow_unstable,
               "accept a time step (in tau_e) beyond the scheme's stability");
}

}  // namespace bagnold
