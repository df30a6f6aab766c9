// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/run/protocols/cascade/cascade.hpp"
#include "src/run/validate_scene.hpp"
#include "src/cli/commands.hpp"
#include "src/run/pictures.hpp"
#include "src/run/start_or_resume.hpp"
#include "src/cli/signals.hpp"
#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/trajectory_parts.hpp"

namespace bagnold {

int run_command(RunOptions const& options) {
  Scene scene = read_scene(options.scene_file, options.overrides);
  checked_plan(scene, options.allow_unstable);
  scene = resolved(std::move(scene));
  Machine const machine = choose(options.machine, scene);
  auto from_file = states_in_file(runs_of(scene).front());  // read before anything is written

  auto const name = options.folder.empty()
                        ? std::filesystem::path("results") / options.scene_file.stem()
                        : options.folder;
  catch_signals();
  RunFolder const folder = RunFolder::make(name, options.force);
  io::replace_text(folder.scene(), write_scene(scene));
  if (scene.shear.protocol == "cascade") return run_cascade(folder, scene, machine, options.quiet);
  return run_from_start(folder, scene, machine, options.quiet, std::move(from_file));
}

namespace {

void refuse_sweep(std::filesystem::path const& folder) {
  if (std::filesystem::exists(folder / "points.json"))
    throw InputError(
        fmt::format("{}: holds a sweep; the command that began it goes on with it: `bagnold "
                    "sweep FILE --out {}`",
                    folder.string(), folder.string()));
}

}  // namespace

int resume_command(ResumeOptions const& options) {
  catch_signals();
  refuse_sweep(options.folder);
  RunFolder const folder = RunFolder::open(options.folder);
  if (io::run_finished(folder.path())) {
    folder.remove_trajectory_parts();
    if (std::filesystem::exists(folder.scene()) && !cascade_in(folder))
      draw_missing_pictures(folder, read_scene(folder.scene()));
    fmt::print("{} is finished: nothing to resume\n", options.folder.string());
    return 0;
  }
  if (auto const scene = cascade_in(folder))
    return run_cascade(folder, *scene, choose(options.machine, *scene), options.quiet);
  return go_on_in(folder, options.machine, options.quiet);
}

}  // namespace bagnold
