// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/law_engines.hpp"

#include <algorithm>
#include <list>

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/type_list.hpp"

namespace bagnold {

namespace {

/// A list: what was looked up stays where it is when another law is added.
std::list<LawEngines>& all() {
  static std::list<LawEngines> engines = [] {
    std::list<LawEngines> listed;
    for_each_type<Laws>(
        [&]<class Law>(std::type_identity<Law>) { listed.push_back(engines_of<Law>()); });
    return listed;
  }();
  return engines;
}

}  // namespace

LawEngines const& engines_for(Scene const& scene) {
  return *std::ranges::find(all(), scene.disks.model, &LawEngines::name);
}

void add_engines(LawEngines const& engines) { all().push_back(engines); }

}  // namespace bagnold
