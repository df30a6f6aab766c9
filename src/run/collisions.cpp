// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/collisions.hpp"

#include <cmath>
#include <numbers>

#include "kernels/physics/laws/contact.hpp"
#include "src/config/contact_rates.hpp"

namespace bagnold {

namespace {

/// Duration of a head-on collision of two small disks, [tau_e]: half a period of the damped
/// oscillator, or the relaxation time where it is overdamped. No contact is much shorter. overlap:
/// the mean one, 0 if it is not known.
double head_on_duration(Scene const& scene, double overlap = 0) {
  ContactRates r(scene);
  if (!r.harmonic && overlap > 0 &&
      overlap < largest_relative_overlap)  // stiffness ~ overlap^(a - 2)
    r.stiffness *= std::pow(overlap / largest_relative_overlap, scene.disks.force_exponent - 2);
  double const rate = r.normal / 2;  // of the velocity's decay
  double const omega2 = r.stiffness - rate * rate;
  if (omega2 > 0) return std::numbers::pi / std::sqrt(omega2);
  return 1 / (rate - std::sqrt(-omega2));
}

}  // namespace

double mean_overlap(Scene const& scene, double elastic_pressure, double contacts, double area) {
  double const pairs = static_cast<double>(scene.disks.count) * contacts / 2;
  return std::pow(2 * elastic_pressure * area / pairs, 1 / (scene.disks.force_exponent - 1));
}

double collisions_per_disk(Scene const& scene, double contacts, double strain, double overlap) {
  return contacts * strain / scene.shear.strain_rate / head_on_duration(scene, overlap);
}

double collisions_of(Scene const& scene, double contact_time) {
  return contact_time / head_on_duration(scene);
}

}  // namespace bagnold
