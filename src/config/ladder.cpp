// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/abilities.hpp"
#include "src/config/collision_loss.hpp"
#include "src/config/events.hpp"
#include "src/config/jamming.hpp"
#include "src/config/laws.hpp"
#include "src/config/names.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/stability.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

/// Cost of a step of implicit damping in steps of two stages: 1.8 in CD, 2.5 where disks roll.
constexpr double implicit_cost = 2.3;

/// Strain of a quasi-static step. Steps of 3e-4 cost 0.8 as much a strain, and take Z of CD up by
/// 0.5%; of CD_rot they take Z up by 1.5%.
constexpr double quasi_static_strain = 2e-4;

/// Cost of such a step of 1024 disks in steps of two stages (AVX-512), and the power of N with
/// which it grows: 18 for 64 disks, 40 for 256, 470 for 4096 were measured.
constexpr double quasi_static_cost = 130, quasi_static_power = 0.75;

/// Largest cost of quasi-static steps, over that of implicit damping, that is worth a trial.
constexpr double most_quasi_static_cost = 0.6;

/// Largest cost of a method, over that of two stages at their rule, that is worth a trial.
constexpr double most_cost = 0.75;

/// Finest division of a step of the run.
constexpr std::int64_t most_parts = 16;

/// Strain of a run from which on the default tries methods. The stretches of one that is refused
/// add 3% to the cost of such a run (implicit damping), or 17% (two stages at twice their step).
constexpr double least_strain = 4.0;

/// Longest stretch, over the shortest that will do, that is worth a side which the run steps
/// itself.
constexpr double most_stretch = 1.5;

constexpr char exact_stops[] = "many-contacts";  ///< an engine that can stop after every step

bool damps_sliding(Scene::Disks const& disks) {
  auto const constants = law_of(disks).constants(disks);
  return constants.tangential >= ImplicitDamping::least_tangential_share * constants.normal;
}

bool chooses(Scene const& scene) {
  auto const& shear = scene.shear;
  auto const& measure = scene.measure;
  return scene.integration.scheme == automatic && scene.integration.time_step.word != of_papers &&
         abilities_of(scene).scheme.empty() &&
         time_step(scene) <= rule_time_step(scene, default_scheme) * (1 + 1e-12) &&
         shear.rate_stays() && !scene.driven() && !measure.contacts;
}

/// Two steps of two stages in one, where that is stable and a collision loses its energy.
bool bears_twice(Scene const& scene, double dt) {
  return 2 * dt <= dense_flow_time_step(scene, default_scheme) &&
         contact_spectral_radius(scene, default_scheme, 2 * dt) <= 1 + 1e-9 &&
         std::abs(collision_loss_error(scene, default_scheme, 2 * dt)) < scene.integration.accuracy;
}

double cost_of_step(Scene const& scene, std::string_view scheme) {
  if (scheme == backward_euler)
    return quasi_static_cost *
           std::pow(static_cast<double>(scene.disks.count) / 1024, quasi_static_power);
  return is_implicit(scheme) ? implicit_cost : 1;
}

double cost_of(Scene const& scene, Method const& method) {
  return cost_of_step(scene, method.scheme) / static_cast<double>(method.length);
}

/// Quasi-static steps, if they cost enough less than a method of implicit damping.
std::optional<Method> quasi_static(Scene const& scene, Method const& implicit) {
  auto const& given = scene.integration;
  bool const suits = given.engine == automatic && !scene.rotates() && scene.disks.elasticity <= 1 &&
                     given.accuracy >= usual_accuracy && !scene.shear.run_per_rate();
  if (!suits) return {};
  auto asked = scene;
  asked.integration.engine = quasi_static_engine;
  asked.integration.scheme = backward_euler;
  asked.integration.time_step = automatic;
  asked.measure.bias = false;  // which a run asks of all methods that it takes
  if (!why_not(asked).empty() || !misused_quasi_static(asked).empty()) return {};
  double const step_strain = time_step(scene) * scene.shear.strain_rate;
  auto const in_implicit = static_cast<std::int64_t>(quasi_static_strain / step_strain /
                                                     static_cast<double>(implicit.length));
  Method const one{backward_euler, in_implicit * implicit.length};
  bool const pays =
      in_implicit > 0 && cost_of(scene, one) < most_quasi_static_cost * cost_of(scene, implicit);
  return pays ? std::optional(one) : std::nullopt;
}

/// Strain between frames, if there are any: steps are no longer.
double least_frame_strain(Scene const& scene) {
  double least = std::numeric_limits<double>::infinity();
  auto const& measure = scene.measure;
  if (measure.profiles || measure.fields || measure.rotation) least = measure.frame_strain;
  if (scene.output.trajectory_strain > 0) least = std::min(least, scene.output.trajectory_strain);
  return least;
}

/// Methods that may cost less than two stages at their rule.
std::vector<Method> cheaper(Scene const& scene) {
  std::vector<Method> list;
  double const dt = time_step(scene);
  if (damps_sliding(scene.disks) && abilities_of(scene).implicit_schemes.empty()) {
    double const gain = rule_time_step(scene, ImplicitDamping::name) / dt;
    auto const length = static_cast<std::int64_t>(gain * (1 + 1e-12));
    list.push_back({ImplicitDamping::name, length});
    if (length % 2 == 0) list.push_back({ImplicitDamping::name, length / 2});
    if (auto const one = quasi_static(scene, list.front())) list.push_back(*one);
  }
  if (bears_twice(scene, dt)) list.push_back({default_scheme, 2});
  auto const cost = [&](Method const& one) { return cost_of(scene, one); };
  double const step_strain = dt * scene.shear.strain_rate, frames = least_frame_strain(scene);
  std::erase_if(list, [&](Method const& one) {
    return !(cost(one) <= most_cost) || static_cast<double>(one.length) * step_strain > frames;
  });
  std::ranges::stable_sort(list, {}, cost);
  return list;
}

/// Strain of a stretch of a pair. A method that is to hold less than usual_accuracy has long ones.
double stretch_of(Scene const& scene, Ladder const& ladder) {
  auto const damps = [](Method const& one) { return damps_all(one.scheme); };
  if (ladder.judges_all || std::ranges::none_of(ladder.methods, damps)) return stretch_strain;
  double const gap = std::sqrt(jamming_fraction / scene.disks.packing_fraction) - 1;
  double const least = std::max(least_stretch_strain, gap / 2);
  return std::clamp(stretch_time * scene.shear.strain_rate, std::min(least, stretch_strain),
                    stretch_strain);
}

}  // namespace

double least_inertia(Scene const& scene) {
  double const normal = law_of(scene.disks).constants(scene.disks).normal;
  return std::min(most_kinetic, 1e-4 * std::max(1.0, 1 / normal));
}

bool damps_all(std::string_view scheme) { return is_implicit(scheme) || scheme == backward_euler; }

Ladder ladder_of(Scene const& scene) {
  Ladder ladder;
  if (chooses(scene)) {
    ladder.methods = cheaper(scene);
    ladder.usual = ladder.methods.size();
    ladder.judges_all = scene.measure.bias || scene.integration.accuracy < usual_accuracy;
  }
  ladder.methods.push_back({default_scheme});
  auto const& engine = scene.integration.engine;
  bool const divides = engine == automatic || engine == steps_engine || engine == exact_stops;
  for (std::int64_t parts = 2; ladder.judges_all && divides && parts <= most_parts; parts *= 2)
    ladder.methods.push_back({default_scheme, 1, parts});
  if (!ladder.has_choice()) return ladder;
  for (auto const& one : ladder.methods) ladder.whole = std::lcm(ladder.whole, one.length);
  double const step_strain = time_step(scene) * scene.shear.strain_rate;
  if (!(step_strain > 0)) return ladder;  // a cascade, which has one for each rate
  auto const multiple = [&](double strain, std::int64_t of) {
    double const times = std::ceil(strain / step_strain / static_cast<double>(of) * (1 - 1e-12));
    return static_cast<std::int64_t>(std::clamp(times, 1.0, most_steps)) * of;
  };
  ladder.stretch = stretch_of(scene, ladder);
  bool const shortens = ladder.stretch < stretch_strain;
  double const sample = scene.output.sample_strain;
  ladder.window = multiple(shortens ? std::min(sample, ladder.stretch / 3) : sample, ladder.whole);
  auto const longest = std::ranges::max(ladder.methods, {}, &Method::length).length;
  double const stretch =
      std::max(ladder.stretch, static_cast<double>(fewest_stretch_steps * longest) * step_strain);
  auto const in_thirds = multiple(stretch, 3 * ladder.window);
  ladder.shares = static_cast<double>(in_thirds) * step_strain <= most_stretch * stretch;
  ladder.grid = ladder.shares ? in_thirds : multiple(stretch, ladder.window);  // no two overlap
  return ladder;
}

bool may_change_method(Scene const& scene) {
  return scene.integration.scheme == automatic && ladder_of(scene).has_choice();
}

bool auto_is_default(Scene const& scene) {
  bool const gains = std::ranges::max(scene.shear.strain.each) >= least_strain ||
                     scene.integration.accuracy < usual_accuracy;
  bool const by_rule = scene.integration.time_step.word == automatic;
  auto asked = scene;
  asked.integration.scheme = automatic;
  return gains && by_rule && may_change_method(asked);
}

Scene with_method(Scene scene, Method const& method) {
  scene.integration.time_step =
      time_step(scene) * static_cast<double>(method.length) / static_cast<double>(method.parts);
  scene.integration.scheme = method.scheme;
  if (damps_all(method.scheme)) scene.integration.skin = automatic;  // reaches further
  if (method.scheme == backward_euler) scene.integration.engine = quasi_static_engine;
  if (method.parts > 1) scene.integration.engine = exact_stops;
  return scene;
}

}  // namespace bagnold
