// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/cli/commands.hpp"
#include "src/config/plan.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "src/config/toml_text.hpp"
#include "src/io/state_file.hpp"
#include "src/start/start.hpp"
#include "src/sweep/sweep_table.hpp"

namespace bagnold {

int validate_command(RunOptions const& options) {
  auto const origin = options.scene_file.string();
  if (sweep::is_sweep(read_text(options.scene_file), origin)) return validate_sweep_command(options);
  Scene scene = read_scene(options.scene_file, options.overrides);
  Plan const plan = make_plan(scene);
  check_feasible(scene, plan, options.allow_unstable);
  warn(plan_warning(plan));
  if (scene.start.kind == "state") fit_to_scene(io::read_states(scene.start.file), scene);
  scene.integration.time_step = plan.time_step;

  double const disk_steps =
      static_cast<double>(plan.steps) * static_cast<double>(scene.disks.count * scene.disks.replicas);
  RunTime const time = estimated_time(scene, plan);
  fmt::print("{}\n", write_scene(scene));
  fmt::print("# box            {:.6g} d_s wide\n", scene.box_length());
  fmt::print("# time step      {:.6g} tau_e, spectral radius of a single contact {:.6f}\n",
             plan.time_step, contact_spectral_radius(scene, plan.time_step));
  if (scene.disks.replicas > 1)
    fmt::print("# replicas       {}, seeds {} to {}; the steps and windows below are of each\n",
               scene.disks.replicas, scene.disks.seed,
               scene.disks.seed + scene.disks.replicas - 1);
  fmt::print("# steps          {}, {:.4g} million disk-steps\n", plan.steps, disk_steps / 1e6);
  fmt::print("# windows        {} of {} steps, {} discarded, evaluated every {} steps\n",
             plan.windows, plan.window_steps, plan.discarded_windows, plan.every);
  if (plan.trajectory_steps > 0) {  // 7 numbers a disk and frame, in parts and then in one file
    double const frames =
        1 + static_cast<double>(plan.steps) / static_cast<double>(plan.trajectory_steps);
    double const disks = static_cast<double>(scene.disks.count * scene.disks.replicas);
    fmt::print("# trajectory     {:.0f} frames, {:.3g} MB, twice that at the end of the run\n", frames,
               frames * 7 * 8 * disks / 1e6);
  }
  fmt::print("# memory         {:.3g} MB\n", memory_needed(scene, plan) / 1e6);
  fmt::print("# estimated time {} to {} on one core\n", time_text(time.least),
             time_text(time.most));
  return 0;
}

}  // namespace bagnold
