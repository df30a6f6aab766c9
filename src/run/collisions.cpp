// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/collisions.hpp"

#include <cmath>
#include <numbers>

#include "src/config/contact_rates.hpp"

namespace bagnold {

namespace {

/// Duration of a head-on collision of two small disks, [tau_e]: half a period of the damped
/// oscillator, or the relaxation time where it is overdamped. No contact is much shorter.
double head_on_duration(Scene const& scene) {
  ContactRates const r(scene);
  double const rate = r.normal / 2;  // of the velocity's decay
  double const omega2 = r.stiffness - rate * rate;
  if (omega2 > 0) return std::numbers::pi / std::sqrt(omega2);
  return 1 / (rate - std::sqrt(-omega2));
}

}  // namespace

double collisions_per_disk(Scene const& scene, double contacts, double strain) {
  return contacts * strain / scene.shear.strain_rate / head_on_duration(scene);
}

double collisions_of(Scene const& scene, double contact_time) {
  return contact_time / head_on_duration(scene);
}

}  // namespace bagnold
