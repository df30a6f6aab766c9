// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/abilities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/events.hpp"
#include "src/config/laws.hpp"
#include "src/config/names.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/schemes.hpp"

namespace bagnold {

namespace {

constexpr WhyNot steps_some_disks =
    "steps the disks that touch alone, where integration.scheme = \"{}\" solves for all together";
constexpr WhyNot needs_straight_flights =
    "needs disks that fly straight between contacts, which drive.kind = \"{}\" does not leave";
constexpr WhyNot needs_whole_flights =
    "needs flights that a change of the rate does not break off, as it does in shear.protocol = "
    "\"{}\"";
constexpr WhyNot needs_linear_damping =
    "needs damping that is linear in the velocity, which model \"{}\" has not";

constexpr WhyNot steps_by_strain = "steps by strain, where shear.protocol = \"{}\" goes by time";

constexpr Abilities by_events = {
    .engine = event_engine,
    .scheme = exact_contacts,
    .own_scheme = true,
    .paper_time_step =
        "has no time step, integration.time_step = \"paper\" is that of another scheme",
    .nonlinear_laws = needs_linear_damping,
    .overdamped_contacts = "needs contacts that end of themselves: {}",
    .other_repulsions =
        "solves contacts in closed form, which harmonic repulsion alone has, "
        "disks.force_exponent = 2, here it is {}",
    .drives = needs_straight_flights,
    .pieces = needs_whole_flights,
    .bias = "has no step whose bias a finer one could show",
    .devices = "goes from event to event on the host"};

/// Events, and by turns steps of all disks.
constexpr Abilities by_turns() {
  auto abilities = by_events;
  abilities.scheme = default_scheme;
  abilities.contacts = "does not follow contacts from one engine to the other";
  abilities.bias = {};  // that of the steps
  return abilities;
}

constexpr std::array engines = {
    Abilities{.engine = "auto"},
    Abilities{.engine = steps_engine},
    Abilities{.engine = "reference"},
    Abilities{.engine = "few-contacts",
              .implicit_schemes = steps_some_disks,
              .drives = needs_straight_flights},
    Abilities{.engine = "many-contacts"},
    Abilities{.engine = "lookahead",
              .implicit_schemes = steps_some_disks,
              .drives = needs_straight_flights,
              .pieces = needs_whole_flights},
    Abilities{.engine = quasi_static_engine,
              .scheme = backward_euler,
              .own_scheme = true,
              .paper_time_step = "has steps of a strain, integration.time_step = \"paper\" is that "
                                 "of another scheme",
              .nonlinear_laws = needs_linear_damping,
              .other_repulsions = "was measured with harmonic repulsion alone, "
                                  "disks.force_exponent = 2, here it is {}",
              .drives = "has no part for drive.kind = \"{}\" in its equations",
              .ramps = steps_by_strain,
              .pieces = steps_by_strain,
              .contacts = "does not see contacts that begin and end within a step",
              .profiles = "has no stresses of single disks",
              .bias = "shares no instants with a method of shorter steps",
              .devices = "solves on one thread of the host"},
    by_events};

/// Something a scene may ask for by one key.
struct Demand {
  std::string_view key;
  WhyNot Abilities::*why_not;
  bool (*asked)(Scene const&);
  std::string (*value)(Scene const&);  ///< for the "{}" of a reason
  std::string_view instead = {};       ///< remedy beside another engine
};

/// nullptr: refused by its name.
LawFacts const* law_of_scene(Scene const& scene) { return known_laws().find(scene.disks.model); }

bool is_linear(Scene const& scene) {
  auto const* law = law_of_scene(scene);
  return !law || law->linear;
}

bool is_overdamped(Scene const& scene) {
  return law_of_scene(scene) && scene.disks.elasticity <= least_underdamped_elasticity(scene);
}

constexpr auto no_value = [](Scene const&) { return std::string(); };

constexpr std::array demands = {
    Demand{"integration.scheme", &Abilities::implicit_schemes,
           [](Scene const& scene) { return is_implicit(scene.integration.scheme); },
           [](Scene const& scene) { return scene.integration.scheme; },
           "set integration.scheme = \"auto\""},
    Demand{"integration.time_step", &Abilities::paper_time_step,
           [](Scene const& scene) { return scene.integration.time_step.word == of_papers; },
           no_value, "set integration.time_step = \"auto\""},
    Demand{"drive.kind", &Abilities::drives, [](Scene const& scene) { return scene.driven(); },
           [](Scene const& scene) { return scene.drive.kind; }},
    Demand{"disks.force_exponent", &Abilities::other_repulsions,
           [](Scene const& scene) {
             return scene.disks.force_exponent != HarmonicRepulsion::force_exponent;
           },
           [](Scene const& scene) { return fmt::format("{}", scene.disks.force_exponent); }},
    Demand{"disks.model", &Abilities::nonlinear_laws,
           [](Scene const& scene) { return !is_linear(scene); },
           [](Scene const& scene) { return scene.disks.model; }},
    Demand{"disks.elasticity", &Abilities::overdamped_contacts,
           [](Scene const& scene) { return is_linear(scene) && is_overdamped(scene); },
           [](Scene const& scene) {
             return fmt::format("below Q = {:.3g} they are overdamped, disks.elasticity = {}",
                                least_underdamped_elasticity(scene), scene.disks.elasticity);
           }},
    Demand{"shear.protocol", &Abilities::ramps,
           [](Scene const& scene) { return scene.shear.ramps(); },
           [](Scene const& scene) { return scene.shear.protocol; }},
    Demand{"shear.protocol", &Abilities::pieces,
           [](Scene const& scene) { return scene.shear.by_pieces() || scene.shear.controlled(); },
           [](Scene const& scene) { return scene.shear.protocol; }},
    Demand{"measure.contacts", &Abilities::contacts,
           [](Scene const& scene) { return scene.measure.contacts; }, no_value,
           "set measure.contacts = false"},
    Demand{"measure.profiles", &Abilities::profiles,
           [](Scene const& scene) { return scene.measure.profiles; }, no_value,
           "set measure.profiles = false"},
    Demand{"measure.bias", &Abilities::bias, [](Scene const& scene) { return scene.measure.bias; },
           no_value, "set measure.bias = false"}};

constexpr std::string_view another_engine = "integration.engine = \"auto\"";

/// "integration.engine = "..." (why); remedy"
std::string because(Abilities const& abilities, std::string const& why, std::string_view instead) {
  return fmt::format("integration.engine = \"{}\" ({}); {}{}{}", abilities.engine, why, instead,
                     instead.empty() ? "set " : ", or ", another_engine);
}

/// Refusal of a scheme by an engine that steps by one alone.
std::vector<Refusal> another_scheme(Scene const& scene, Abilities const& abilities) {
  auto const& scheme = scene.integration.scheme;
  if (abilities.scheme.empty() || scheme == automatic || scheme == abilities.scheme) return {};
  return {{{"integration.scheme", "integration.engine"},
           because(abilities,
                   fmt::format("steps by \"{}\", not by integration.scheme = \"{}\"",
                               abilities.scheme, scheme),
                   "set integration.scheme = \"auto\"")}};
}

}  // namespace

std::span<Abilities const> all_engines() { return engines; }

Abilities const& abilities_of(Scene const& scene) {
  auto const* found = std::ranges::find(engines, scene.integration.engine, &Abilities::engine);
  return found == engines.end() ? engines.front() : *found;
}

bool can_take_turns(Scene const& scene) { return why_not(scene, by_turns()).empty(); }

bool is_scheme_of_an_engine(std::string_view scheme) {
  return std::ranges::any_of(
      engines, [&](auto const& one) { return one.own_scheme && one.scheme == scheme; });
}

std::vector<Refusal> why_not(Scene const& scene, Abilities const& abilities) {
  auto list = another_scheme(scene, abilities);
  for (auto const& demand : demands) {
    auto const reason = abilities.*demand.why_not;
    if (reason.empty() || !demand.asked(scene)) continue;
    list.push_back({{demand.key, "integration.engine"},
                    because(abilities, fmt::format(fmt::runtime(reason), demand.value(scene)),
                            demand.instead)});
  }
  return list;
}

std::vector<Refusal> why_not(Scene const& scene) {
  auto list = why_not(scene, abilities_of(scene));
  auto const& asked = scene.integration;
  for (auto const& one : engines)
    if (one.own_scheme && asked.scheme == one.scheme && abilities_of(scene).scheme.empty())
      list.push_back(
          {{"integration.scheme", "integration.engine"},
           fmt::format(
               "integration.scheme = \"{}\" (is stepped by integration.engine = \"{}\" "
               "alone, here it is \"{}\"); set that engine, or integration.scheme = \"auto\"",
               one.scheme, one.engine, asked.engine)});
  return list;
}

}  // namespace bagnold
