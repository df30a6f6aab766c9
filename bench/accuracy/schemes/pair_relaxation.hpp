// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "bench/accuracy/world.hpp"

namespace bagnold::accuracy {

/// One component of the relative motion of two disks under their damping alone: v' = -(k_d/mu) v.
struct Relaxing {
  Real mass = 0;   ///< mu, [m]
  Real steps = 0;  ///< z = k_d dt / mu

  /// Impulse over -v that leaves exp(-z) v, [m].
  Real slowing() const { return -mass * std::expm1(-steps); }

  /// Impulse over minus the increment that leaves (1 - exp(-z))/z of it, [m].
  Real holding() const {
    if (steps < 1e-5) return mass * steps / 2;
    return mass * (1 + std::expm1(-steps) / steps);
  }
};

/// The two components, for each class of pairs, with masses cut in `parts` equal parts.
///
///     1/mu = 1/m_i + 1/m_j;   tangential, rolling: 1/mu_t = 1/mu + s_ji^2/I_i + s_ij^2/I_j,
///
/// with s_ji = d_i/2, s_ij = d_j/2; that is 3/mu for I = m d^2/8.
struct PairRelaxation {
  Relaxing normal[pair_classes], tangential[pair_classes];

  template <ContactLaw Law>
  PairRelaxation(Law const& law, SpeciesTable const& table, Real time, Real parts = 1) {
    for (int big = 0; big < pair_classes; ++big) {
      int const a = big == 2, b = big != 0;
      auto const rolling = [&](int s) {
        return Law::rotates ? table.diameter[s] * table.diameter[s] * table.inverse_inertia[s] / 4
                            : Real(0);
      };
      Real const inverse = parts * (table.inverse_mass[a] + table.inverse_mass[b]);
      Real const turning = inverse + parts * (rolling(a) + rolling(b));
      normal[big] = {1 / inverse, law.normal_damping() * time * inverse};
      tangential[big] = {1 / turning, law.tangential_damping() * time * turning};
    }
  }
};

/// -normal (v . n) n - tangential [v - (v . n) n]
template <class T>
Vec2<T> along(Touch<T> const& t, Vec2<T> const& velocity, Real normal, Real tangential) {
  return static_cast<T>(tangential - normal) * dot(velocity, t.normal) * t.normal -
         static_cast<T>(tangential) * velocity;
}

}  // namespace bagnold::accuracy
