// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "src/config/contact_rates.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

/// Collisions of a disk after which its velocity is that of the flow and not of the start.
constexpr double fewest_collisions = 10;

/// How long two small disks touch in a head-on collision, [tau_e]: half a period of the damped
/// oscillator; where it is overdamped the time to relax. No contact is much shorter.
double head_on_duration(Scene const& scene) {
  ContactRates const r(scene);
  double const rate = r.normal / 2;  // of the velocity's decay
  double const omega2 = r.stiffness - rate * rate;
  if (omega2 > 0) return std::numbers::pi / std::sqrt(omega2);
  return 1 / (rate - std::sqrt(-omega2));
}

}  // namespace

std::optional<Warning> few_collisions(FinishedRun const& finished) {
  auto const& scene = finished.run.scene;
  double const contacts = finished.mean("Z");
  double const time = finished.measured_strain() / scene.shear.strain_rate;
  double const collisions = contacts * time / head_on_duration(scene);  // Z = 2 tau_dur nu_coll
  if (!(collisions < fewest_collisions)) return {};
  return Warning{
      "few_collisions",
      {{"collisions_per_disk", collisions}},
      fmt::format(
          "a disk collides {:.2g} times at most in the measured strain of {:.3g}; it takes {:.0f} "
          "to forget the start",
          collisions, finished.measured_strain(), fewest_collisions),
      "make the run longer",
      longer_run(finished.run, 1.5 * fewest_collisions / collisions)};
}

}  // namespace bagnold
