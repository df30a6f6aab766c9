// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/physics/named_entries.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Damping of a law that is linear in the velocity, kernels/physics/laws/contact.hpp, [m / tau_e].
struct LawConstants {
  double normal = 0;
  double tangential = 0;
};

/// Facts on a contact law for reading and checking a scene; facts_of.hpp takes them from the type.
struct LawFacts {
  std::string_view name;
  bool rotates;
  bool separate_constants;
  bool linear;                                     ///< in the velocity
  LawConstants (*constants)(Scene::Disks const&);  ///< 0 for a law that is not linear

  /// Time step of the papers at an elasticity Q, [tau_e].
  double (*paper_time_step)(double elasticity);

  /// Time step of a scheme's own rule, [tau_e]; that of the papers where the scheme cannot step the
  /// law.
  double (*rule_time_step)(std::string_view scheme, Scene::Disks const&);
};

/// Facts on all laws: first those of the list in kernels/physics/laws/laws.hpp, then registered
/// ones.
NamedEntries<LawFacts> const& known_laws();

/// Law of a scene. Throws InputError where there is no such law.
LawFacts const& law_of(Scene::Disks const& disks);

/// Registers a law (src/engine/register_law.hpp). Throws InputError where the name is taken.
void register_facts(LawFacts const& law);

}  // namespace bagnold
