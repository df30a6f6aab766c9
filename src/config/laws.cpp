// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/laws.hpp"

#include <fmt/format.h>

#include "kernels/physics/laws/laws.hpp"
#include "src/config/errors.hpp"
#include "src/config/facts_of.hpp"
#include "src/config/names.hpp"

namespace bagnold {

namespace {

NamedEntries<LawFacts>& laws() {
  return NamedEntries<LawFacts>::of<Laws>([]<class Law>() { return facts_of<Law>(); });
}

}  // namespace

NamedEntries<LawFacts> const& known_laws() { return laws(); }

LawFacts const& law_of(Scene::Disks const& disks) {
  if (auto const* law = laws().find(disks.model)) return *law;
  throw InputError(fmt::format("disks.model = \"{}\" (is no contact law); use {}", disks.model,
                               choice(model_names())));
}

void register_facts(LawFacts const& law) {
  if (laws().find(law.name))
    throw InputError(fmt::format(
        "model \"{}\" (there is a law of this name already); give the new one another name",
        law.name));
  laws().add(law);
}

}  // namespace bagnold
