// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/disk_stress.hpp"

#include "src/engine/law_engines.hpp"
#include "src/measure/disk_search.hpp"

namespace bagnold {

std::vector<Sums<false>> disk_stress(Scene const& scene, State const& state) {
  return engines_for(scene).disk_sums(scene, state, disk_search(state, 0.0));
}

}  // namespace bagnold
