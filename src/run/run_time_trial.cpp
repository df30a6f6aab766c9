// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_time_trial.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "src/config/events.hpp"
#include "src/config/strain_rates.hpp"
#include "src/engine/contacts/contact_columns.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/measure/contacts.hpp"
#include "src/measure/make_frames.hpp"
#include "src/run/run_measured.hpp"
#include "src/run/stretch_size.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

constexpr std::int64_t most_disks = 1024, most_given_disks = 16384;
constexpr double first_trial_rate = 1e-3;  // [1/tau_e]: random disks need much strain below
constexpr double factor = 2;               // within which estimates lie (docs/run_time.md)
constexpr std::int64_t endless = std::int64_t{1} << 50;
constexpr double picture_seconds = 1.2, frames_picture_seconds = 1.5;
constexpr double bytes_per_second = 150e6, bytes_of_a_frame = 56;  // of a disk in a trajectory

/// Rate at which a scene is tried; of one that only stops any will do.
double trial_rate(Scene const& scene) {
  double const rate = typical_rate(scene);
  return rate > 0 ? rate : first_trial_rate;
}

/// Factor by which a step of a disk takes longer in a system of this size, beyond the caches
/// (docs/run_time.md).
double slowdown(std::int64_t disks) {
  return std::max(1.0, 1 + 0.08 * std::log2(static_cast<double>(disks) / 2048));
}

/// CPU time of a call, [s].
template <class Call>
double timed(Call const& call) {
  auto const begun = cpu_seconds();
  call();
  return cpu_seconds() - begun;
}

/// A system that is stepped as in a run, with windows and contacts, from a step of its plan on.
class Stepped {
 public:
  Stepped(Scene const& scene, Plan const& plan, State state, std::int64_t step) : plan_(plan) {
    Snapshot from = first_snapshot(std::move(state));
    double const turns =
        from.state.offset / from.state.box_length - from.state.box_aspect * plan.strain(step);
    from.step = step;
    from.initial_offset = (turns - std::floor(turns)) * from.state.box_length;
    simulation_ = make_simulation(scene, std::move(from), "serial");
    auto const columns = simulation_->columns();
    measurement_.windows.columns = static_cast<std::size_t>(columns);
    measurement_.open.first = step / plan.window_steps;
    if (!scene.measure.contacts) return;
    measurement_.open.contacts =
        watch_contacts(scene, plan_, columns, scene.disks.seed, measurement_.frames);
    measurement_.windows.columns += ContactColumns::count;
  }

  /// Steps for about this CPU time or strain, or to the end of the plan. Returns the time of a
  /// step, [s]; if no step was left, that of the previous call.
  double step(double seconds, double strain = 1e300) {
    auto const first = simulation_->step();
    auto const begun = cpu_seconds();
    run_measured(*simulation_, plan_, measurement_, [&] {
      return cpu_seconds() - begun < seconds &&
             plan_.strain(simulation_->step()) - plan_.strain(first) < strain;
    });
    auto const steps = simulation_->step() - first;
    if (steps > 0) step_time_ = (cpu_seconds() - begun) / static_cast<double>(steps);
    return step_time_;
  }

  /// Time that the scene's observers take for one frame, [s].
  double frame(Scene const& scene) const {
    Plan plan = plan_;
    plan.trajectory_steps = 0;
    Frames frames = make_frames(scene, plan, state(), {}, {});
    constexpr int repeats = 3;
    return timed([&] {
             for (int k = 0; k < repeats; ++k) frames.show(*simulation_, -1);
           }) /
           repeats;
  }

  State state() const { return simulation_->state(); }

 private:
  Plan plan_;
  Measurement measurement_;
  std::unique_ptr<Simulation> simulation_;
  double step_time_ = 0;
};

/// Steps of a plan with equal costs, and one of them.
struct Stretch {
  std::int64_t step;
  double steps;
};

/// Stretches of a ramp: those before its legs, and four equal parts of its legs, as rates grow by
/// the same factor in equal times.
std::vector<Stretch> stretches_of(Ramp const& ramp, std::int64_t window_steps) {
  std::vector<Stretch> list;
  if (ramp.fast_steps > 0) list.push_back({0, static_cast<double>(ramp.fast_steps)});
  if (ramp.slow_steps > 0) list.push_back({ramp.fast_steps, static_cast<double>(ramp.slow_steps)});
  constexpr std::int64_t parts = 4;
  for (std::int64_t k = 0; k < parts; ++k) {
    auto const middle = (2 * k + 1) * (ramp.leg_steps() / window_steps) / (2 * parts);
    list.push_back({ramp.first_leg() + middle * window_steps,
                    static_cast<double>(ramp.legs * ramp.leg_steps()) / parts});
  }
  return list;
}

}  // namespace

RunTime run_time(double expected) { return {expected, expected / factor, expected * factor}; }

double pictures_take(Scene const& scene) {
  if (!scene.output.plot) return 0;
  bool const of_frames = scene.measure.profiles || scene.measure.fields;
  return picture_seconds + (of_frames ? frames_picture_seconds : 0);
}

RunTimeTrial::RunTimeTrial(Scene const& scene, std::optional<State> start, double budget)
    : small_(scene) {
  bool const given = start && scene.disks.count <= most_given_disks;
  if (!given) small_.disks.count = std::min(scene.disks.count, most_disks);
  small_.disks.replicas = 1;
  small_.start.rescale = true;
  small_.shear.protocol = "steady";
  small_.integration.scheme = default_scheme;
  small_.integration.time_step = automatic;
  small_.integration.engine = "auto";
  small_.measure = {};
  double const target = trial_rate(scene);
  small_.shear.strain_rate = std::max(target, first_trial_rate);
  if (given) {
    state_ = *std::move(start);
    return;
  }
  start_seconds_ = timed([&] {
    auto started = random_start(small_);
    start_iterations_ = started.record.at("start_iterations");
    state_ = std::move(started.state);
  });
  shear(small_.shear.strain_rate, 2.0, budget / 2);
  auto const decades = std::floor(std::log10(small_.shear.strain_rate / target) - 0.01);
  for (int k = 1; k <= decades; ++k)
    shear(small_.shear.strain_rate / 10, 0.2, budget / 2 / decades);
}

void RunTimeTrial::shear(double rate, double strain, double budget) {
  small_.shear.strain_rate = rate;
  Plan plan = make_plan(small_);
  plan.steps = plan.windows = endless;
  Stepped stepped(small_, plan, fit_to_scene({state_}, small_).front().state, 0);
  stepped.step(budget, strain);
  state_ = stepped.state();
}

RunTimeTrial::Cost RunTimeTrial::cost(Scene const& run, Plan const& plan, double budget) {
  Scene scene = run;
  if (scene.integration.engine == automatic && !may_take_events(run))
    scene.integration.engine = steps_engine;  // as fewer disks might take events
  scene.disks.count = small_.disks.count;
  scene.disks.replicas = 1;
  scene.start.rescale = true;
  Plan trial = plan;
  if (plan.pieces) {  // as at one rate
    scene.shear.protocol = "steady";
    scene.shear.strain_rate = trial_rate(run);
    scene.shear.strain = 1.0;
    trial = make_plan(scene);
  }
  trial.discarded_windows = 0;
  std::vector<Stretch> stretches{{0, static_cast<double>(plan.steps)}};
  if (plan.ramp)
    stretches = stretches_of(*plan.ramp, plan.window_steps);
  else
    trial.steps = trial.windows = endless;
  Cost cost;
  for (auto const& [step, steps] : stretches) {
    Scene fitted = scene;
    if (plan.ramp) fitted.shear.strain_rate = plan.ramp->piece(step).rate;
    Stepped stepped(scene, trial, fit_to_scene({state_}, fitted).front().state, step);
    double const share = budget / static_cast<double>(stretches.size());
    stepped.step(share / 3);  // lists, windows and the flow find their ways
    cost.steps += steps * stepped.step(2 * share / 3);
    cost.frame = stepped.frame(scene);
    state_ = stepped.state();
  }
  return cost;
}

double RunTimeTrial::start_takes(Scene const& run, double size, double slower) const {
  if (run.start.kind != "random" || start_iterations_ == 0) return 0;
  // larger starts take more iterations, and exceed the cache in each (docs/run_time.md)
  double const iterations =
      std::min(static_cast<double>(run.start.iterations), start_iterations_ * std::pow(size, 0.15));
  return start_seconds_ * size * slower * slower * iterations / start_iterations_;
}

RunTime RunTimeTrial::time_of(Scene const& run, Plan const& plan, double budget) {
  auto const [steps, frame] = cost(run, plan, budget);
  auto const disks = static_cast<double>(run.disks.count);
  double const size = disks / static_cast<double>(small_.disks.count);
  double const slower = slowdown(run.disks.count) / slowdown(small_.disks.count);
  auto const frames = [&](std::int64_t spacing, std::int64_t discarded) {
    return static_cast<double>(plan.steps - discarded) / static_cast<double>(spacing) + 1;
  };
  double system = size * slower * steps + start_takes(run, size, slower);
  auto const& measure = run.measure;
  if (measure.profiles || measure.fields || measure.rotation)
    system += size * frame * frames(plan.frame_steps, plan.first_step());
  if (plan.trajectory_steps > 0)
    system += disks * bytes_of_a_frame / bytes_per_second * frames(plan.trajectory_steps, 0);
  return run_time(static_cast<double>(run.disks.replicas) * system + pictures_take(run));
}

}  // namespace bagnold
