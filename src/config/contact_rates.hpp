// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "src/config/scene.hpp"

namespace bagnold {

/// Two small disks in contact, the lightest pair: squared frequency of the undamped motion,
/// [1/tau_e^2], and rates of damping along and across the contact, [1/tau_e].
struct ContactRates {
  double stiffness;   ///< 2 k/m, k = 1/d^2; for alpha = 5/2 at 20% overlap
  double normal;      ///< 2 k_n/m
  double tangential;  ///< 2 k_t/m, three times that where disks roll

  explicit ContactRates(Scene const& scene) {
    auto const& disks = scene.disks;
    double const mass = scene.mass_by_area() ? std::numbers::pi / 2 : 1.0;
    double const inverse = 2 / mass;
    double const largest_overlap = 0.2;
    stiffness =
        inverse * (disks.force_exponent - 1) * std::pow(largest_overlap, disks.force_exponent - 2);
    bool const general = disks.model == "general";
    double const rolling = scene.rotates() ? 3.0 : 1.0;
    normal = inverse * (general ? disks.damping_normal : 1.0) / disks.elasticity;
    tangential =
        disks.model == "CD_n"
            ? 0.0
            : inverse * rolling * (general ? disks.damping_tangential : 1.0) / disks.elasticity;
  }
};

}  // namespace bagnold
