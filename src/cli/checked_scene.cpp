// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/checked_scene.hpp"

#include <vector>

#include "src/cli/commands.hpp"
#include "src/cli/target_error.hpp"
#include "src/config/cascade.hpp"

namespace bagnold {

void check_scene(Scene const& scene, Plan const& plan, bool allow_unstable) {
  check_feasible(scene, plan, allow_unstable);
  check_target(scene);
}

Plan checked_plan(Scene const& scene, bool allow_unstable) {
  std::vector<Plan> plans;
  for (auto const& run : runs_of(scene)) {
    plans.push_back(make_plan(run));
    check_scene(run, plans.back(), allow_unstable);
    warn(plan_warning(plans.back()));
  }
  return plans.front();
}

}  // namespace bagnold
