// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/abilities.hpp"
#include "src/config/collision_loss.hpp"
#include "src/config/errors.hpp"
#include "src/config/events.hpp"
#include "src/config/ladder.hpp"
#include "src/config/names.hpp"
#include "src/config/stability.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/run/bias/methods.hpp"
#include "src/run/stretch_size.hpp"

namespace bagnold::bias {

namespace {

constexpr std::int64_t finest_parts = 8;  ///< of the usual step
constexpr std::int64_t fewest_instants = 30;
constexpr char serial[] = "serial";

Scene steps_alone(Scene scene) {
  scene.integration.engine = steps_engine;
  scene.disks.replicas = 1;
  scene.measure = {};
  return scene;
}

/// A method, and its step in usual ones, or usual ones in it.
struct Stepping {
  Method method;
  Scene scene;
};

/// Methods that can step the scene, implicit ones first, each from its longest step on.
std::vector<Stepping> methods_for(Scene const& scene) {
  std::vector<Method> list;
  double const dt = time_step(scene);
  auto const largest = [&](std::string_view scheme) {
    return static_cast<std::int64_t>(rule_time_step(scene, scheme) / dt * (1 + 1e-12));
  };
  Scene implicit = scene;
  implicit.integration.scheme = ImplicitDamping::name;
  implicit.integration.engine = automatic;
  if (why_not(implicit).empty() && !scene.driven())
    for (auto length = largest(ImplicitDamping::name); length > 1; length /= 2)
      list.push_back({ImplicitDamping::name, length});
  for (std::int64_t length = 2; length >= 1; --length)
    if (contact_spectral_radius(scene, default_scheme, dt * static_cast<double>(length)) <=
        1 + 1e-9)
      list.push_back({default_scheme, length});
  for (std::int64_t parts = 2; parts < finest_parts; parts *= 2)
    list.push_back({default_scheme, 1, parts});
  double const papers = rule_time_step(scene, ModifiedVelocityVerlet::name);
  list.push_back({ModifiedVelocityVerlet::name, 1,
                  std::max<std::int64_t>(1, std::llround(std::ceil(dt / papers * (1 - 1e-12))))});
  std::vector<Stepping> all;
  for (auto const& one : list) all.push_back({one, steps_alone(with_method(scene, one))});
  return all;
}

/// A system that steps a stretch, and its sums at each of its instants.
class Path {
 public:
  /// start: of a run by the scene `from`.
  Path(Scene const& scene, State const& start, Scene const& from, Method const& method)
      : scene_(scene), start_(handed_over(start, from, scene, serial)), method_(method) {}

  using GoOn = std::function<bool()>;

  /// Steps `ticks` usual steps; sums at each step of its own, or at each usual one. Returns false
  /// if go_on did.
  bool step(std::int64_t ticks, GoOn const& go_on) {
    return step(ticks * method_.parts / method_.length, method_.parts, method_.parts, go_on);
  }

  /// CPU seconds of as many steps as a run takes them, which evaluates every tenth; none: stopped.
  std::optional<double> seconds(std::int64_t ticks, GoOn const& go_on) {
    constexpr std::int64_t every = 10;
    if (!step(ticks * method_.parts / method_.length, every * method_.parts, every * method_.parts,
              go_on))
      return {};
    return seconds_;
  }

  /// Averages over every `stride`-th instant.
  Averages averages(std::int64_t stride) const {
    return averages_of(scene_, start_.box_length, windows_, static_cast<std::size_t>(stride));
  }

 private:
  bool step(std::int64_t steps, std::int64_t window, std::int64_t every, GoOn const& go_on) {
    auto const simulation = make_simulation(scene_, first_snapshot(start_), serial);
    Sampling const sampling{.window_steps = window, .every = every, .last_step = steps};
    windows_ = {};
    simulation->advance(1, sampling, windows_);  // finds the neighbours
    auto const first = cpu_seconds();
    if (!StretchSize().step(*simulation, sampling, windows_, go_on)) return false;
    seconds_ = (cpu_seconds() - first) * static_cast<double>(steps) /
               static_cast<double>(std::max<std::int64_t>(1, steps - 1));
    return true;
  }

  Scene scene_;
  State start_;
  double seconds_ = 0;  ///< of the steps, as if the first had taken as long as others
  Method method_;
  OpenWindows windows_;
};

}  // namespace

Chart chart(Scene const& given, State const& start, ChartRequest const& request) {
  Scene scene = given;
  scene.integration.engine = automatic;
  scene.integration.scheme = default_scheme;
  scene.integration.time_step = automatic;
  scene.integration.skin = automatic;
  scene.integration.time_step = time_step(scene);
  double const step_strain = time_step(scene) * scene.shear.strain_rate;
  auto const all = methods_for(scene);
  Method const finest{default_scheme, 1, finest_parts};
  Chart made{
      .finest = steps_alone(with_method(scene, finest)), .states = 0, .strain = 0, .methods = {}};

  std::int64_t whole = 3;  // thirds of a stretch hold whole steps of each method
  for (auto const& one : all) whole = std::lcm(whole, 3 * one.method.length);
  auto const multiple = [&](double strain) {
    double const ticks = std::max(strain / step_strain, static_cast<double>(fewest_instants));
    return std::llround(std::ceil(ticks / static_cast<double>(whole))) * whole;
  };
  auto const ticks = multiple(stretch_strain);
  made.strain = static_cast<double>(ticks) * step_strain;

  double share = 0;
  std::string what = "warming up";
  auto const go_on = [&] { return request.go_on(share, what); };
  Scene to_warm_up = scene;
  to_warm_up.integration.engine = steps_engine;  // velocities of its states are those of steps
  auto const run = make_simulation(to_warm_up, first_snapshot(start), serial);
  OpenWindows unused;
  StretchSize size;
  std::vector<std::vector<Pair>> pairs(all.size());
  std::vector<std::vector<double>> seconds(all.size());
  std::vector<bool> failed(all.size(), false);
  auto const warm = request.warm_up > 0 ? multiple(request.warm_up) : 0;
  auto const next = multiple(request.apart);
  for (std::size_t k = 0; k < request.states; ++k) {
    auto const step = warm + static_cast<std::int64_t>(k) * next;
    if (!size.step(*run, {.last_step = step}, unused, go_on)) break;
    State const state = run->state();
    Path finer(made.finest, state, to_warm_up, finest);
    what = fmt::format("state {} of {}, the finest method", k + 1, request.states);
    if (!finer.step(ticks, go_on)) break;
    bool stopped = false;
    for (std::size_t m = 0; m < all.size() && !stopped; ++m) {
      auto const& [method, of] = all[m];
      share = (static_cast<double>(k) + static_cast<double>(m + 1) / (1.0 + all.size())) /
              static_cast<double>(request.states);
      what = fmt::format("state {} of {}, {} at {:.4g}", k + 1, request.states, method.scheme,
                         time_step(of));
      if (failed[m]) continue;
      try {
        Path coarse(of, state, to_warm_up, method);
        if (!coarse.step(ticks, go_on)) {
          stopped = true;
          break;
        }
        pairs[m].push_back({run->step(), coarse.averages(1), finer.averages(method.length)});
        auto const took = Path(of, state, to_warm_up, method).seconds(ticks, go_on);
        if (took)
          seconds[m].push_back(*took);
        else
          stopped = true;
      } catch (NumericalError const&) {
        failed[m] = true;
      }
    }
    if (stopped) break;
    made.states = k + 1;
  }
  for (std::size_t m = 0; m < all.size(); ++m) {
    auto const& of = all[m].scene;
    ChartedMethod one{.scene = of, .time_step = time_step(of), .judgement = {}};
    one.disk_steps =
        static_cast<double>(scene.disks.count) / (one.time_step * scene.shear.strain_rate);
    one.failed = failed[m];
    if (!one.failed && pairs[m].size() > 1) {
      auto const n = static_cast<double>(seconds[m].size());
      double sum = 0, squares = 0;
      for (double const s : seconds[m])
        sum += s / made.strain, squares += s * s / made.strain / made.strain;
      one.seconds = sum / n;
      one.seconds_error =
          std::sqrt(std::max(0.0, squares / n - one.seconds * one.seconds) / (n - 1));
      double const loss = collision_loss_error(of, of.integration.scheme, one.time_step);
      one.judgement = judge(pairs[m], scene.integration.accuracy, made.strain, loss);
    }
    made.methods.push_back(std::move(one));
  }
  return made;
}

}  // namespace bagnold::bias
