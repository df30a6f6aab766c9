// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/commands.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/terminal.hpp"
#include "src/config/scene_file.hpp"
#include "src/run/run.hpp"

namespace bagnold {

namespace {

int exit_code(RunEnd end) { return end == RunEnd::done ? 0 : 128 + stop_signal(); }

}  // namespace

int run_command(SceneOptions const& options) {
  Scene const scene = read_scene(options.scene_file, options.overrides);
  auto const folder = options.folder.empty()
                          ? std::filesystem::path("results") / options.scene_file.stem()
                          : options.folder;
  catch_signals();
  Terminal terminal(options.quiet);
  return exit_code(run(scene, folder,
                       {.machine = options.machine,
                        .replace = options.force,
                        .allow_unstable = options.allow_unstable,
                        .monitor = &terminal}));
}

int resume_command(ResumeOptions const& options) {
  catch_signals();
  Terminal terminal(options.quiet);
  return exit_code(resume(options.folder, {.machine = options.machine, .monitor = &terminal}));
}

}  // namespace bagnold
