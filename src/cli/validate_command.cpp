// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "src/cli/options.hpp"
#include "src/config/abilities.hpp"
#include "src/config/cascade.hpp"
#include "src/config/control.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/stability.hpp"
#include "src/config/time_step.hpp"
#include "src/config/toml_text.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/run/machine.hpp"
#include "src/run/run_time_estimate.hpp"
#include "src/run/start_or_resume.hpp"
#include "src/run/trajectory_size.hpp"
#include "src/run/validate_scene.hpp"
#include "src/sweep/sweep_table.hpp"

namespace bagnold {

namespace {

void print_ramp(Ramp const& ramp) {
  auto const tau = [&](std::int64_t steps) { return static_cast<double>(steps) * ramp.time_step; };
  if (ramp.fast_steps > 0)
    fmt::print("# before         strain {:.4g} at {:g}\n",
               static_cast<double>(ramp.strain(ramp.fast_steps)), Ramp::fast_rate);
  auto const slow = ramp.strain(ramp.first_leg()) - ramp.strain(ramp.fast_steps);
  fmt::print("# before         strain {:.4g} at {:g}\n", static_cast<double>(slow), ramp.lowest);
  auto const top = ramp.piece(ramp.first_leg() + ramp.leg_steps() - 1);
  auto const leg = ramp.strain(ramp.first_leg() + ramp.leg_steps()) - ramp.strain(ramp.first_leg());
  fmt::print(
      "# ramp           {} times up to {:.4g} and down, each way {:.4g} tau_e, strain {:.4g}, in "
      "{} "
      "rates of {} steps\n",
      ramp.legs / 2, top.rate, tau(ramp.leg_steps()), static_cast<double>(leg), ramp.leg_pieces,
      ramp.piece_steps);
}

/// "23 min (11 min to 46 min) on one core, 12 min on 2"
std::string in_words(RunTime const& time, int threads) {
  auto text = fmt::format("{} ({} to {}) on one core", time_text(time.expected),
                          time_text(time.least), time_text(time.most));
  if (threads > 1) text += fmt::format(", {} on {}", time_text(time.expected / threads), threads);
  return text;
}

/// Prints the size and the memory of one run.
void print_plan(Scene const& scene, Plan const& plan) {
  if (plan.ramp) print_ramp(*plan.ramp);
  fmt::print("# {:<14} {:.6g}\n", plan.progress_name(), plan.progress(plan.steps));
  fmt::print("# steps          {}, {:.4g} million disk-steps\n", plan.steps,
             disk_steps(scene, plan) / 1e6);
  fmt::print("# windows        {} of {} steps, {}, evaluated every {} steps\n", plan.windows,
             plan.window_steps,
             scene.shear.discard || plan.ramp
                 ? fmt::format("{} discarded", plan.discarded_windows * plan.stages)
                 : "the transient discarded (MSER-5)",
             plan.every);
  if (plan.control_steps > 0)
    fmt::print("# pieces         of {} steps{}\n", plan.control_steps,
               plan.by_time ? fmt::format(", box_inertia {:.4g} m", box_inertia(scene)) : "");
  for (auto const& [name, error] : scene.shear.target_error)
    fmt::print("# until          relative error of {} is at most {}, or the strain is spent\n",
               name, error);
  if (plan.trajectory_steps > 0) {
    auto const [frames, bytes] = trajectory_size(scene, plan);
    fmt::print("# trajectory     {:.0f} frames, {:.3g} MB, twice that at the end of the run\n",
               frames, bytes / 1e6);
  }
  fmt::print("# memory         {:.3g} MB\n", memory_needed(scene, plan) / 1e6);
}

int validate_command(ValidateOptions const& options) {
  auto const origin = options.scene_file.string();
  if (sweep::is_sweep(read_text(options.scene_file), origin))
    return validate_sweep_command(options);
  Scene scene = read_scene(options);
  Plan const plan = validated_plan(scene, options.allow_unstable);
  auto const runs = runs_of(scene);
  auto started = states_in_file(runs.front());
  scene = resolved(std::move(scene));

  fmt::print("{}\n", write_scene(scene));
  bool const square = scene.disks.box_aspect == 1;
  fmt::print("# box            {:.6g} d_s wide{}\n", scene.box_length(),
             square ? "" : fmt::format(", {:.6g} d_s high", scene.box_height()));
  auto const scheme = scheme_of(scene);
  if (is_scheme_of_an_engine(scheme)) {
    fmt::print("# time step      {:.6g} tau_e, {}, stable at any\n", plan.time_step, scheme);
  } else {
    fmt::print("# time step      {:.6g} tau_e, {}, spectral radius of a single contact {:.6f}\n",
               plan.time_step, scheme, contact_spectral_radius(scene, plan.time_step));
    fmt::print(
        "# stable         up to {:.3g} tau_e for six contacts a disk, measured {:.3g} (Z = 3.5)\n",
        largest_stable_time_step(scene, scheme), dense_flow_time_step(scene, scheme));
  }
  if (scene.disks.replicas > 1)
    fmt::print("# replicas       {}, seeds {} to {}; the steps and windows below are of each\n",
               scene.disks.replicas, scene.disks.seed, scene.disks.seed + scene.disks.replicas - 1);
  int const threads = default_threads(scene);
  std::optional<RunTimes> times;
  if (!options.no_time) {
    std::optional<State> first;
    if (!started.empty()) first = std::move(started.front().state);
    times = times_of_runs(runs, std::move(first));
  }
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs.size() > 1) fmt::print("#\n# strain rate    {:g}\n", runs[k].shear.strain_rate);
    print_plan(runs[k], make_plan(runs[k]));
    if (times) fmt::print("# estimated time {}\n", in_words(times->each[k], threads));
  }
  if (!times) return 0;
  if (runs.size() > 1)
    fmt::print("#\n# all {} rates    {}\n", runs.size(), in_words(times->sum(), threads));
  fmt::print("#                {}\n", times->how);
  return 0;
}

}  // namespace

Command add_validate(Words program) {
  auto const options = std::make_shared<ValidateOptions>();
  Words command = add_command(program, "validate",
                              "check a scene; print it resolved, its steps, memory and time");
  add_scene_options(command, *options);
  command.flag("--no-time", options->no_time,
               "no estimate of the time, which takes trials of a second or two");
  return {command, [options] { return validate_command(*options); }};
}

}  // namespace bagnold
