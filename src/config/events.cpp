// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/species.hpp"
#include "src/config/engine_refusals.hpp"
#include "src/config/laws.hpp"
#include "src/config/quasi_static.hpp"

namespace bagnold {

namespace {

/// Largest k_n with which all contacts oscillate: 2 sqrt(mu)/d_ij of the pair that has the
/// smallest.
double most_damping(Scene const& scene) {
  auto const table = make_species_table(scene.mass_by_area());
  double least = 1e300;
  for (Species i = 0; i < 2; ++i)
    for (Species j = 0; j < 2; ++j) {
      double const mass = 1 / (table.inverse_mass[i] + table.inverse_mass[j]);
      least = std::min(least, 2 * std::sqrt(mass) / class_distance(pair_class(i, j)));
    }
  return least;
}

double normal_damping(Scene const& scene) {
  auto const* law = known_laws().find(scene.disks.model);
  return law ? law->constants(scene.disks).normal : 0;
}

std::vector<Refusal> of_another_engine(Scene const& scene) {
  if (scene.integration.scheme != exact_contacts) return {};
  return {{{"integration.scheme", "integration.engine"},
           fmt::format("integration.scheme = \"{}\" (is that of integration.engine = \"{}\" alone, "
                       "here it is \"{}\"); set that engine, or integration.scheme = \"auto\"",
                       exact_contacts, event_engine, scene.integration.engine)}};
}

}  // namespace

bool has_events(Scene const& scene) { return scene.integration.engine == event_engine; }
bool is_adaptive(Scene const& scene) { return scene.integration.engine == adaptive_engine; }

bool is_scheme_of_an_engine(std::string_view scheme) {
  return scheme == backward_euler || scheme == exact_contacts;
}

double least_underdamped_elasticity(Scene const& scene) {
  return scene.disks.elasticity * normal_damping(scene) / most_damping(scene);
}

std::vector<Refusal> not_events(Scene const& scene) {
  bool const adaptive = is_adaptive(scene);
  if (!has_events(scene) && !adaptive) return of_another_engine(scene);
  EngineRefusals refuse(scene.integration.engine);
  std::string const other = "set integration.engine = \"auto\"";
  auto const& scheme = scene.integration.scheme;
  if (adaptive && scheme != automatic && scheme != default_scheme)
    refuse({"integration.scheme"},
           fmt::format("steps by \"{}\" where it does not go from event to event, not by "
                       "integration.scheme = \"{}\"",
                       default_scheme, scheme),
           "set integration.scheme = \"auto\", or another engine");
  if (!adaptive && scheme != automatic && scheme != exact_contacts)
    refuse({"integration.scheme"},
           fmt::format("solves contacts by \"{}\", not by integration.scheme = \"{}\"",
                       exact_contacts, scheme),
           "set integration.scheme = \"auto\", or another engine");
  if (scene.integration.time_step.word == of_papers)
    refuse({"integration.time_step"},
           "has no time step, integration.time_step = \"paper\" is that of another scheme",
           "set \"auto\"");
  if (scene.driven())
    refuse({"drive.kind"},
           fmt::format("needs disks that fly straight, under drive.kind = \"{}\" they do not",
                       scene.drive.kind),
           other);
  if (scene.disks.force_exponent != HarmonicRepulsion::force_exponent)
    refuse({"disks.force_exponent"},
           fmt::format("solves contacts in closed form, which {} repulsion alone has, "
                       "disks.force_exponent = {}, here it is {}",
                       HarmonicRepulsion::name, HarmonicRepulsion::force_exponent,
                       scene.disks.force_exponent),
           other);
  if (refuse.unless_linear(scene, other) && normal_damping(scene) >= most_damping(scene))
    refuse({"disks.elasticity"},
           fmt::format("needs contacts that end of themselves: below Q = {:.3g} they are "
                       "overdamped, disks.elasticity = {}",
                       least_underdamped_elasticity(scene), scene.disks.elasticity),
           other);
  if (adaptive && scene.measure.contacts)
    refuse({"measure.contacts"}, "does not follow contacts from one engine to the other",
           "set measure.contacts = false, or another engine");
  return refuse.take();
}

}  // namespace bagnold
