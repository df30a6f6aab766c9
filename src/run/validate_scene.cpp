// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/validate_scene.hpp"

#include <fmt/format.h>

#include <vector>

#include "src/run/messages.hpp"
#include "src/run/target_error.hpp"
#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"

namespace bagnold {

namespace {

/// Of a run shorter than a window nothing is left when its transient is discarded.
void refuse_less_than_a_window(Scene const& scene, Plan const& plan) {
  if (plan.ramp || plan.steps >= plan.window_steps) return;
  throw InputError(fmt::format(
      "shear.strain = {} (must be at least output.sample_strain = {}, a window of averages); raise "
      "shear.strain or lower output.sample_strain",
      scene.shear.strain.at(0), scene.output.sample_strain));
}

}  // namespace

void validate_scene(Scene const& scene, Plan const& plan, bool allow_unstable) {
  check_feasible(scene, plan, allow_unstable);
  check_target(scene);
  refuse_less_than_a_window(scene, plan);
}

Plan validated_plan(Scene const& scene, bool allow_unstable) {
  std::vector<Plan> plans;
  for (auto const& run : runs_of(scene)) {
    plans.push_back(make_plan(run));
    validate_scene(run, plans.back(), allow_unstable);
    warn(plan_warning(plans.back()));
  }
  return plans.front();
}

}  // namespace bagnold
