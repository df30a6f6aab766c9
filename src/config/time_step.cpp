// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/physics/drives/drive.hpp"
#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/abilities.hpp"
#include "src/config/events.hpp"
#include "src/config/ladder.hpp"
#include "src/config/laws.hpp"
#include "src/config/oscillation.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/schemes.hpp"
#include "src/config/skin.hpp"

namespace bagnold {

static_assert(DefaultScheme::name == default_scheme);

double rule_time_step(Scene const& scene, std::string_view scheme) {
  return law_of(scene.disks).rule_time_step(scheme, scene.disks);
}

double drag_rate(Scene const& scene) {
  auto const table = make_species_table(scene.mass_by_area());
  double const drag = scene.drive.drag, of_motion = drag * table.inverse_mass[0];
  double const of_spin = spin_drag(drag, table.diameter[0]) * table.inverse_inertia[0];
  return scene.rotates() ? std::max(of_motion, of_spin) : of_motion;
}

std::string_view scheme_of(Scene const& scene) {
  if (auto const& engine = abilities_of(scene); engine.own_scheme) return engine.scheme;
  auto const& given = scene.integration.scheme;
  return given == automatic ? DefaultScheme::name : std::string_view(given);
}

double paper_time_step(Scene::Disks const& disks) {
  return law_of(disks).paper_time_step(disks.elasticity);
}

namespace {

/// Largest time step at which a drag acts on a lone disk as in continuous time, within a percent
/// even with the papers' scheme: a fifth of the shortest relaxation time, that of small disks,
/// [tau_e].
double drag_time_step(Scene const& scene) {
  double const rate = drag_rate(scene);
  return rate > 0 ? 0.2 / rate : std::numeric_limits<double>::infinity();
}

}  // namespace

double time_step(Scene const& scene) {
  auto const& given = scene.integration.time_step;
  if (given.number) return *given.number;
  if (is_quasi_static(scene)) return quasi_static_time_step(scene);
  auto const longest = [&] {
    if (has_events(scene)) return event_time_unit;
    if (given.word == of_papers) return paper_time_step(scene.disks);
    return std::min(rule_time_step(scene, scheme_of(scene)), drag_time_step(scene));
  };
  double const rule = longest();
  auto const divides = [&](double piece) { return piece / std::ceil(piece / rule * (1 - 1e-12)); };
  if (scene.shear.ramps()) return divides(scene.shear.ramp_every);
  if (scene.shear.oscillates())
    return divides(oscillation_period(scene) / static_cast<double>(scene.shear.cycle_pieces));
  return rule;
}

Scene resolved(Scene scene) {
  bool const changes = may_change_method(scene);
  if (!is_quasi_static(scene) || !scene.shear.run_per_rate())  // else one for each rate
    scene.integration.time_step = time_step(scene);
  scene.integration.skin = skin(scene);
  if (!changes) scene.integration.scheme = scheme_of(scene);
  return scene;
}

}  // namespace bagnold
