// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/facts_of.hpp"
#include "src/engine/law_engines_of.hpp"

namespace bagnold {

/// Registers a contact law of a user's program under its name. Scenes may then name it, and every
/// engine runs it by every scheme that can step it, like the laws of the list. To be called before
/// the first scene is read, by one thread. Throws InputError if the name is taken.
template <ContactLaw Law>
void register_law() {
  register_facts(facts_of<Law>());
  register_engines(engines_of<Law>());
}

}  // namespace bagnold
