// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/abilities.hpp"
#include "src/config/collision_loss.hpp"
#include "src/config/events.hpp"
#include "src/config/laws.hpp"
#include "src/config/names.hpp"
#include "src/config/stability.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

/// Cost of a step of implicit damping in steps of two stages, as the passes over contacts count.
constexpr double implicit_cost = 2.3;

/// Largest cost of a method, over that of two stages at their rule, that is worth a trial.
constexpr double most_cost = 0.75;

/// Strain between places at which the method may change.
constexpr double place_strain = 0.1;

/// Finest division of a step of the run.
constexpr std::int64_t most_parts = 16;

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
         shear.rate_stays() && !scene.driven() && !measure.contacts && !measure.fields &&
         !measure.rotation;
}

/// Two steps of two stages in one, where that is stable and a collision loses its energy.
bool bears_twice(Scene const& scene, double dt) {
  return 2 * dt <= dense_flow_time_step(scene, default_scheme) &&
         contact_spectral_radius(scene, default_scheme, 2 * dt) <= 1 + 1e-9 &&
         std::abs(collision_loss_error(scene, default_scheme, 2 * dt)) < scene.integration.accuracy;
}

double cost_of(Method const& method) {
  return (is_implicit(method.scheme) ? implicit_cost : 1) / static_cast<double>(method.length);
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
  }
  if (bears_twice(scene, dt)) list.push_back({default_scheme, 2});
  std::erase_if(list, [](Method const& one) { return !(cost_of(one) <= most_cost); });
  std::ranges::stable_sort(list, {}, cost_of);
  return list;
}

}  // namespace

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
  ladder.window = multiple(scene.output.sample_strain, ladder.whole);
  ladder.grid = multiple(place_strain, ladder.window);
  return ladder;
}

bool may_change_method(Scene const& scene) {
  return scene.integration.scheme == automatic && ladder_of(scene).has_choice();
}

Scene with_method(Scene scene, Method const& method) {
  scene.integration.time_step =
      time_step(scene) * static_cast<double>(method.length) / static_cast<double>(method.parts);
  scene.integration.scheme = method.scheme;
  if (is_implicit(method.scheme)) scene.integration.skin = automatic;  // reaches further
  if (method.parts > 1) scene.integration.engine = exact_stops;
  return scene;
}

}  // namespace bagnold
