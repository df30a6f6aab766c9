// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "kernels/physics/species.hpp"
#include "src/config/contact_rates.hpp"

namespace bagnold::accuracy {

/// Two small disks that meet, in closed form: mu x'' = -k_d x' - k_e x for the overlap x, x(0) = 0,
/// x'(0) = v_0, until it is 0 again (P1 Eq. 7), and an exponential decay of the sliding.
struct DampedContact {
  double decay;       ///< beta = k_d / 2 mu, [1 / tau_e]
  double frequency2;  ///< 1/mu - beta^2, [1 / tau_e^2]; negative: no way back
  double sliding;     ///< rate at which the velocity difference of the points of contact decays
  double turning;     ///< its share that is a change of the centres' velocities: mu_t / mu

  explicit DampedContact(Scene const& scene) {
    ContactRates const r(scene);
    decay = r.normal / 2;
    frequency2 = r.stiffness - decay * decay;
    sliding = r.tangential;
    turning = 1 / tangential_mobility(scene.rotates());
  }

  double duration() const {  ///< [tau_e]
    return frequency2 > 0 ? std::numbers::pi / std::sqrt(frequency2)
                          : std::numeric_limits<double>::infinity();
  }
  double restitution() const { return frequency2 > 0 ? std::exp(-decay * duration()) : 0; }

  /// Tangential velocity of the centres after the contact over that before it.
  double tangential() const { return 1 - turning * (1 - std::exp(-sliding * duration())); }

  /// x(t) for v_0 = 1, [tau_e].
  double overlap(double t) const {
    double const w = std::sqrt(std::abs(frequency2));
    if (w * t < 1e-12) return t * std::exp(-decay * t);
    if (frequency2 > 0) return std::exp(-decay * t) * std::sin(w * t) / w;
    return (std::exp((w - decay) * t) - std::exp(-(w + decay) * t)) / (2 * w);
  }
};

}  // namespace bagnold::accuracy
