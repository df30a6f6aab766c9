// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/abilities.hpp"
#include "src/config/events.hpp"
#include "src/config/names.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/time_step.hpp"

namespace bagnold::bias {

namespace {

constexpr std::int64_t quarter = 4;

std::int64_t up(double steps) { return static_cast<std::int64_t>(std::ceil(steps * (1 - 1e-12))); }

/// Scene of a system that is stepped for its sums alone.
Scene bare(Scene scene) {
  if (scene.integration.engine == automatic) scene.integration.engine = steps_engine;
  scene.integration.scheme = scheme_of(scene);
  scene.integration.time_step = time_step(scene);
  scene.disks.replicas = 1;
  scene.measure = {};
  return scene;
}

/// finer_step: at most, of implicit damping beside quasi-static steps, and of two stages beside
/// implicit damping. stretch: strain of a stretch, at least.
Methods pair_of(Scene const& scene, double finer_step, double stretch = stretch_strain) {
  Methods of{.coarse = bare(scene), .fine = {}, .ratio = quarter, .third = 0, .grid = 0};
  double const dt = time_step(of.coarse), step_strain = dt * scene.shear.strain_rate;
  of.fine = of.coarse;
  auto const& scheme = of.coarse.integration.scheme;
  of.fine.integration.scheme = default_scheme;
  of.fine.integration.skin = automatic;
  if (scheme == backward_euler) {
    of.fine.integration.scheme = ImplicitDamping::name;
    of.fine.integration.engine = steps_engine;
  }
  if (damps_all(scheme)) of.ratio = std::max<std::int64_t>(1, up(dt / finer_step));
  of.fine.integration.time_step = dt / static_cast<double>(of.ratio);
  of.third = std::max(up(stretch / 3 / step_strain), fewest_stretch_steps / 3);
  of.grid = std::max(up(grid_strain / step_strain), of.length());
  return of;
}

}  // namespace

double Methods::strain() const {
  return static_cast<double>(length()) * time_step(coarse) * coarse.shear.strain_rate;
}

Methods methods_of(Scene const& scene) {
  return pair_of(scene, rule_time_step(scene, default_scheme));
}

Methods methods_of(Scene const& scene, Ladder const& ladder, Method const& method) {
  bool const sharp = scene.integration.accuracy < usual_accuracy;
  double const finer = method.scheme == backward_euler
                           ? rule_time_step(scene, ImplicitDamping::name)
                           : time_step(scene);
  auto of = pair_of(with_method(scene, method), finer / (sharp ? quarter : 1), ladder.stretch);
  if (ladder.shares) of.third = ladder.grid / 3 * method.parts / method.length;
  return of;
}

std::string method_in_words(Scene const& scene) {
  return fmt::format("{}, a step of {:.6g} tau_e", scheme_of(scene), time_step(scene));
}

}  // namespace bagnold::bias
