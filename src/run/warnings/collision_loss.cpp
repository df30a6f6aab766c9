// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/collision_loss.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/config/abilities.hpp"
#include "src/config/names.hpp"
#include "src/config/time_step.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_off = 0.02;  ///< as of energy_balance

}  // namespace

std::optional<Warning> collision_loss(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  auto const scheme = scheme_of(scene);
  if (is_implicit(scheme) || is_scheme_of_an_engine(scheme))
    return {};  // exact, or checked by implicit_inertia, quasi_static_inertia
  double const dt = finished.run.plan.time_step;
  double const off = collision_loss_error(scene, scheme, dt);
  if (std::abs(off) < most_off) return {};
  return Warning{"collision_loss",
                 {{"time_step", dt}, {"collision_loss_error", off}},
                 fmt::format("a head-on collision loses {:.2g}% {} energy than it should: "
                             "integration.time_step = {} is too coarse for {} at Q = {}",
                             100 * std::abs(off), off > 0 ? "more" : "less", dt, scheme,
                             scene.disks.elasticity),
                 "halve it and compare",
                 half_the_step(finished)};
}

}  // namespace bagnold
