// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/laws.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/physics/laws/laws.hpp"
#include "src/config/errors.hpp"
#include "src/config/facts_of.hpp"
#include "src/config/names.hpp"

namespace bagnold {

namespace {

std::vector<LawFacts>& all() {
  static std::vector<LawFacts> laws = [] {
    std::vector<LawFacts> listed;
    for_each_type<Laws>(
        [&]<class Law>(std::type_identity<Law>) { listed.push_back(facts_of<Law>()); });
    return listed;
  }();
  return laws;
}

}  // namespace

std::vector<LawFacts> const& known_laws() { return all(); }

LawFacts const& law_of(Scene::Disks const& disks) {
  auto const found = std::ranges::find(all(), disks.model, &LawFacts::name);
  if (found == all().end())
    throw InputError(fmt::format("disks.model = \"{}\" (is no contact law); use {}", disks.model,
                                 choice(model_names())));
  return *found;
}

void know_law(LawFacts const& law) {
  if (std::ranges::count(all(), law.name, &LawFacts::name) != 0)
    throw InputError(fmt::format(
        "model \"{}\" (there is a law of this name already); give the new one another name",
        law.name));
  all().push_back(law);
}

}  // namespace bagnold
