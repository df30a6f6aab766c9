// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/terminal.hpp"
#include "src/config/scene_file.hpp"
#include "src/run/run.hpp"

namespace bagnold {

namespace {

int run_command(SceneOptions const& options) {
  Scene const scene = read_scene(options);
  auto const folder = options.folder.empty()
                          ? std::filesystem::path("results") / options.scene_file.stem()
                          : options.folder;
  catch_signals();
  Terminal terminal(options.quiet, options.all);
  return exit_code_of(run(scene, folder,
                          {.machine = options.machine,
                           .replace = options.force,
                           .allow_unstable = options.allow_unstable,
                           .strain = {},
                           .monitor = &terminal}));
}

int resume_command(ResumeOptions const& options) {
  catch_signals();
  Terminal terminal(options.quiet, options.all);
  return exit_code_of(
      resume(options.folder,
             {.machine = options.machine, .strain = options.strain, .monitor = &terminal}));
}

void add_all_flag(Words command, bool& all) {
  command.flag("--all", all, "all quantities in the table on the screen");
}

}  // namespace

Command add_run(Words program) {
  auto const options = std::make_shared<SceneOptions>();
  Words command = add_command(program, "run", "run a scene, or go on with its run in the folder");
  add_scene_options(command, *options);
  command.option("--out", options->folder, "folder for the results [results/SCENE]");
  add_all_flag(command, options->all);
  command.flag("--force", options->force,
               "replace the run that is in the folder, of this scene or another");
  add_machine_options(command, options->machine, options->quiet);
  return {command, [options] { return run_command(*options); }};
}

Command add_resume(Words program) {
  auto const options = std::make_shared<ResumeOptions>();
  Words command =
      add_command(program, "resume", "go on with a run, bit for bit: interrupted, or made longer");
  command.option("DIR", options->folder, "folder of the run").required();
  add_all_flag(command, options->all);
  command.option("--strain", options->strain,
                 "make the run that long, in all, with the bits of one that was so from its start; "
                 "of a cascade its last rate");
  add_machine_options(command, options->machine, options->quiet);
  return {command, [options] { return resume_command(*options); }};
}

}  // namespace bagnold
