// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/validate_scene.hpp"

#include <fmt/format.h>

#include <vector>

#include "kernels/cpu/blocks/most_pairs.hpp"
#include "kernels/physics/species.hpp"
#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/ladder.hpp"
#include "src/config/mistakes.hpp"
#include "src/config/names.hpp"
#include "src/config/skin.hpp"
#include "src/run/messages.hpp"
#include "src/run/target_error.hpp"

namespace bagnold {

namespace {

/// Throws InputError for a run shorter than a window: nothing is left when its transient is
/// discarded.
void refuse_less_than_a_window(Scene const& scene, Plan const& plan) {
  if (!plan.has_one_rate() || plan.steps >= plan.window_steps) return;
  throw InputError(fmt::format(
      "shear.strain = {} (must be at least output.sample_strain = {}, a window of averages); raise "
      "shear.strain or lower output.sample_strain",
      scene.shear.strain.at(0), scene.output.sample_strain));
}

/// Least number of pairs in the lists of evenly placed disks, for disks within d_s + skin of each
/// other:
///
///     N n pi (d_s + skin)^2 / 2,    n = phi / [pi (d_s^2 + d_b^2) / 8]
///
/// More pairs, found only when lists are built, are a std::length_error.
double least_pairs(Scene const& scene) {
  double const reach = 1 + skin(scene);
  return 4 * static_cast<double>(scene.disks.count) * scene.disks.packing_fraction * reach * reach /
         (1 + big_diameter * big_diameter);
}

void refuse_too_many_pairs(Scene const& scene) {
  double const pairs = least_pairs(scene);
  if (pairs < static_cast<double>(most_pairs) || scene.integration.engine == "reference") return;
  throw InputError(fmt::format(
      "disks.count = {} with integration.skin = {} (makes lists of {:.2g} pairs or more, limit "
      "{:.2g}); use fewer disks or a smaller skin",
      scene.disks.count, skin(scene), pairs, static_cast<double>(most_pairs)));
}

/// Throws InputError for an accuracy below usual_accuracy that nothing in the run would look at.
void refuse_unseen_accuracy(Scene const& scene) {
  auto const& asked = scene.integration;
  if (asked.accuracy >= usual_accuracy || scene.measure.bias || may_change_method(scene)) return;
  auto not_named = scene;
  not_named.integration.scheme = automatic;
  not_named.integration.time_step = automatic;
  throw InputError(fmt::format(
      "integration.accuracy = {} (nothing looks at it: {}); set measure.bias = true, which tells "
      "whether it is held, or leave it out",
      asked.accuracy,
      may_change_method(not_named)
          ? "the scheme or the time step is named"
          : "scheme = \"auto\" judges no method with measure.contacts or a drive"));
}

}  // namespace

void validate_scene(Scene const& scene, Plan const& plan, bool allow_unstable) {
  Mistakes mistakes;  // reported together
  mistakes.collect("", [&] { refuse_too_many_pairs(scene); });
  mistakes.collect("", [&] { check_feasible(scene, plan, allow_unstable); });
  mistakes.collect("", [&] { refuse_unseen_accuracy(scene); });
  mistakes.collect("", [&] { check_target(scene); });
  mistakes.collect("", [&] { refuse_less_than_a_window(scene, plan); });
  mistakes.throw_any();
}

Plan validated_plan(Scene const& scene, bool allow_unstable) {
  std::vector<Plan> plans;
  for (auto const& run : runs_of(scene)) {
    plans.push_back(make_plan(run));
    validate_scene(run, plans.back(), allow_unstable);
    warn(plan_warning(run, plans.back()));
  }
  return plans.front();
}

}  // namespace bagnold
