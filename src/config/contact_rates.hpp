// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

/// Two small disks in contact, the lightest pair: squared frequency of the undamped motion,
/// [1/tau_e^2], and rates of damping along and across the contact, [1/tau_e]; these 0 for a law
/// that is not linear.
struct ContactRates {
  double stiffness = 0;   ///< 2 k/m; of a force that is not harmonic at the largest overlap
  double normal = 0;      ///< 2 k_n/m
  double tangential = 0;  ///< 2 k_t/m, three times that where disks roll
  double dense_flow = 0;  ///< fastest relaxation of a dense flow, measured
  /// Fastest relaxation of a dense flow along normals over that of one pair, k_n alone: stiffness
  /// and normal damping act through the same contacts.
  static double const network;
  bool harmonic = true;

  explicit ContactRates(Scene const& scene);
};

}  // namespace bagnold
