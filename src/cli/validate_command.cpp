// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/cli/commands.hpp"
#include "src/config/plan.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "src/io/state_file.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// Steps of a disk per second on one core, for an estimate of the time only: what the default engine did
/// in a dense state, and in a dilute one at a rate of 1e-4; at smaller rates it is faster
/// (docs/performance.md).
constexpr double fast_disk_steps = 300e6, slow_disk_steps = 45e6;

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.2g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.2g} min", seconds / 60);
  if (seconds < 172800) return fmt::format("{:.2g} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86400);
}

}  // namespace

int validate_command(RunOptions const& options) {
  Scene scene = read_scene(options.scene_file, options.overrides);
  Plan const plan = make_plan(scene);
  check_feasible(scene, plan, options.allow_unstable);
  warn(plan_warning(plan));
  if (scene.start.kind == "state") fit_to_scene(io::read_state(scene.start.file), scene);
  scene.integration.time_step = plan.time_step;

  double const disk_steps =
      static_cast<double>(plan.steps) * static_cast<double>(scene.disks.count);
  fmt::print("{}\n", write_scene(scene));
  fmt::print("# box            {:.6g} d_s wide\n", scene.box_length());
  fmt::print("# time step      {:.6g} tau_e, spectral radius of a single contact {:.6f}\n",
             plan.time_step, contact_spectral_radius(scene, plan.time_step));
  fmt::print("# steps          {}, {:.4g} million disk-steps\n", plan.steps, disk_steps / 1e6);
  fmt::print("# windows        {} of {} steps, {} discarded, evaluated every {} steps\n",
             plan.windows, plan.window_steps, plan.discarded_windows, plan.every);
  if (plan.trajectory_steps > 0) {  // 7 numbers a disk and frame, in parts and then in one file
    double const frames =
        1 + static_cast<double>(plan.steps) / static_cast<double>(plan.trajectory_steps);
    fmt::print("# trajectory     {:.0f} frames, {:.3g} MB, twice that at the end of the run\n", frames,
               frames * 7 * 8 * static_cast<double>(scene.disks.count) / 1e6);
  }
  fmt::print("# memory         {:.3g} MB\n", memory_needed(scene, plan) / 1e6);
  fmt::print("# estimated time {} to {} on one core\n", duration(disk_steps / fast_disk_steps),
             duration(disk_steps / slow_disk_steps));
  return 0;
}

}  // namespace bagnold
