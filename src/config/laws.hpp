// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/physics/named_entries.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// The damping of a law that is linear in the velocity, kernels/physics/laws/contact.hpp, [m /
/// tau_e].
struct LawConstants {
  double normal = 0;
  double tangential = 0;
  double dense_flow = 0;  ///< fastest relaxation of a dense flow
};

/// What reading and checking a scene asks of a contact law; facts_of.hpp takes it from the type.
struct LawFacts {
  std::string_view name;
  bool rotates;
  bool separate_constants;
  LawConstants (*constants)(Scene::Disks const&);  ///< of a law that is not linear 0

  /// The papers' time step at an elasticity Q, [tau_e].
  double (*paper_time_step)(double elasticity);

  /// That of a scheme's own rule, [tau_e]; of the papers where the scheme cannot step the law.
  double (*rule_time_step)(std::string_view scheme, Scene::Disks const&);
};

/// Of all laws: those of the list in kernels/physics/laws/laws.hpp, then those registered.
NamedEntries<LawFacts> const& known_laws();

/// The law of a scene. Throws InputError where there is no such law.
LawFacts const& law_of(Scene::Disks const& disks);

/// Adds a law (src/engine/register_law.hpp). Throws InputError where the name is taken.
void know_law(LawFacts const& law);

}  // namespace bagnold
