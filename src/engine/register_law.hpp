// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/facts_of.hpp"
#include "src/engine/law_engines_of.hpp"

namespace bagnold {

/// Makes a contact law of a program's own known under its name: scenes may name it, and every
/// engine runs it by every scheme that can step it, as the laws of the list. To be called before
/// the first scene is read, by one thread. Throws InputError where the name is taken.
template <ContactLaw Law>
void register_law() {
  know_law(facts_of<Law>());
  add_engines(engines_of<Law>());
}

}  // namespace bagnold
