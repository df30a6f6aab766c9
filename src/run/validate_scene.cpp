// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/validate_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "kernels/cpu/blocks/most_pairs.hpp"
#include "kernels/physics/species.hpp"
#include "src/config/cascade.hpp"
#include "src/config/control.hpp"
#include "src/config/errors.hpp"
#include "src/config/events.hpp"
#include "src/config/ladder.hpp"
#include "src/config/mistakes.hpp"
#include "src/config/names.hpp"
#include "src/config/skin.hpp"
#include "src/config/time_step.hpp"
#include "src/run/messages.hpp"
#include "src/run/target_error.hpp"

namespace bagnold {

namespace {

constexpr double most_beyond = 0.25;  ///< decades that a ramp may go beyond its highest rate

/// Throws InputError for a run shorter than a window: nothing is left when its transient is
/// discarded.
void refuse_less_than_a_window(Scene const& scene, Plan const& plan) {
  auto const& shear = scene.shear;
  double const window = scene.output.sample_strain * (1 - 1e-9);
  if (plan.by_time && shear.time * shear.strain_rate < window)
    throw InputError(fmt::format(
        "shear.time = {} (must be at least {:.4g} tau_e, a window of averages: "
        "output.sample_strain = {} at shear.strain_rate = {}); raise shear.time or lower "
        "output.sample_strain",
        shear.time, scene.output.sample_strain / shear.strain_rate, scene.output.sample_strain,
        shear.strain_rate));
  bool const is_short = shear.changes_box() ? double{shear.strain} < window
                                            : plan.has_one_rate() && plan.steps < plan.window_steps;
  if (!is_short) return;
  throw InputError(fmt::format(
      "shear.strain = {} (must be at least output.sample_strain = {}, a window of averages); raise "
      "shear.strain or lower output.sample_strain",
      shear.strain.at(0), scene.output.sample_strain));
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

/// Throws InputError for velocities in contact in a run that may end early: where their averages
/// begin depends on where it ends.
void refuse_correlations_with_target(Scene const& scene) {
  if (scene.shear.target_error.empty() || !scene.measure.correlations) return;
  throw InputError(
      "shear.target_error does not go with measure.correlations (where its contacts begin to count "
      "depends on where the run ends); give shear.strain alone");
}

/// Throws InputError for a box that swings on a packing within few steps.
void refuse_light_box(Scene const& scene) {
  auto const& shear = scene.shear;
  if (!shear.finds_rate() || box_inertia(scene) >= least_box_inertia(scene)) return;
  auto const given = shear.box_inertia
                         ? fmt::format("shear.box_inertia = {}", *shear.box_inertia)
                         : fmt::format("shear.strain_rate = {}, which makes box_inertia {:.3g}",
                                       shear.strain_rate, box_inertia(scene));
  throw InputError(
      fmt::format("{} (must be at least {:.3g} for steps of {:.3g}: the box would swing on a "
                  "packing within few "
                  "of them); {}, or lower integration.time_step",
                  given, least_box_inertia(scene), time_step(scene),
                  shear.box_inertia ? "raise it" : "lower it"));
}

/// Throws InputError for a ramp of so few windows that it goes far beyond its highest rate.
void refuse_overshoot(Scene const& scene, Plan const& plan) {
  if (!plan.ramp) return;
  auto const& shear = scene.shear;
  double const beyond =
      static_cast<double>(plan.ramp->leg_pieces) * shear.ramp_every * shear.ramp_rate -
      std::log10(shear.strain_rate_high / shear.strain_rate);
  if (beyond <= most_beyond) return;
  throw InputError(fmt::format(
      "shear.ramp_window = {} (a ramp is whole windows long, so it goes to {:.3g}, beyond "
      "shear.strain_rate_high = {}); take at most {:.6g}, or lower shear.ramp_rate = {}",
      shear.ramp_window, shear.strain_rate_high * std::pow(10.0, beyond), shear.strain_rate_high,
      most_beyond / shear.ramp_rate, shear.ramp_rate));
}

/// Throws InputError for events in units of time in which disks fly far beyond their lists.
void refuse_long_event_unit(Scene const& scene) {
  if (!has_events(scene) || !(scene.integration.time_step.number > longest_event_unit)) return;
  throw InputError(fmt::format(
      "integration.time_step = {:g} (must be at most {:g} with integration.engine = \"{}\", which "
      "builds its lists of neighbours where steps end); set \"auto\"",
      *scene.integration.time_step.number, longest_event_unit, event_engine));
}

}  // namespace

void validate_scene(Scene const& scene, Plan const& plan, bool allow_unstable) {
  Mistakes mistakes;  // reported together
  mistakes.collect("", [&] { refuse_too_many_pairs(scene); });
  mistakes.collect("", [&] { check_feasible(scene, plan, allow_unstable); });
  mistakes.collect("", [&] { refuse_unseen_accuracy(scene); });
  mistakes.collect("", [&] { refuse_light_box(scene); });
  mistakes.collect("", [&] { refuse_overshoot(scene, plan); });
  mistakes.collect("", [&] { refuse_long_event_unit(scene); });
  mistakes.collect("", [&] { check_target(scene); });
  mistakes.collect("", [&] { refuse_correlations_with_target(scene); });
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
