// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include "tests/reference/parameters.hpp"

namespace bagnold::reference {

/// Head-on collision of two disks, alone, without spin: alpha = 2, every law alike.
///
/// The overlap x = d_ij - r_ij obeys, from P1 Eqs. (2) and (3) with m_ij = m_i m_j / (m_i + m_j),
///
///     m_ij x'' = -k_d^n x' - (k_e / d_ij^2) x,   x(0) = 0,   x'(0) = v_0 > 0,
///
/// a damped oscillator: rate beta = k_d^n / (2 m_ij), omega_0^2 = k_e / (m_ij d_ij^2). The law acts
/// as long as r < d_ij, pulling too: the contact ends where x first returns to 0, half a period on,
/// and not where the force vanishes, which is earlier and would give another restitution.
class BinaryCollision {
 public:
  /// Of the disks with these diameters, [d_s]; p gives Q, the mass rule and the law.
  BinaryCollision(Parameters const& p, double diameter_i, double diameter_j) {
    double const m_i = mass(p, diameter_i);
    double const m_j = mass(p, diameter_j);
    double const reduced_mass = m_i * m_j / (m_i + m_j);
    double const contact_distance = (diameter_i + diameter_j) / 2.0;
    bool const own_constant = p.model == Parameters::Model::CD_nt;
    double const damping = (own_constant ? p.damping_normal : 1.0) / p.elasticity;
    decay_rate_ = damping / (2.0 * reduced_mass);
    frequency_squared_ =
        1.0 / (reduced_mass * contact_distance * contact_distance) - decay_rate_ * decay_rate_;
  }

  /// e = exp(-pi beta / Omega), Omega^2 = omega_0^2 - beta^2. Written out it is P1 Eq. (7),
  /// e = exp(-pi / sqrt(4 (m_ij/m_0) (d_s/d_ij)^2 Q^2 - 1)); 0 where the root is not real.
  double restitution() const {
    if (frequency_squared_ <= 0.0) return 0.0;
    return std::exp(-decay_rate_ * duration());
  }

  /// pi / Omega, [tau_e]; infinite at and above critical damping, where x never returns to 0.
  double duration() const {
    if (frequency_squared_ <= 0.0) return std::numeric_limits<double>::infinity();
    return pi_ / std::sqrt(frequency_squared_);
  }

  /// x(t) [d_s] for the approach speed v_0 [d_s / tau_e], 0 <= t <= duration(): v_0 exp(-beta t)
  /// times sin(Omega t) / Omega below critical damping, t at it, sinh(kappa t) / kappa above it,
  /// with kappa^2 = -Omega^2 and the two exponentials drawn together so that none overflows.
  double overlap(double approach_speed, double t) const {
    double const root = std::sqrt(std::abs(frequency_squared_));
    double const decay = std::exp(-decay_rate_ * t);
    if (root == 0.0) return approach_speed * t * decay;
    if (frequency_squared_ > 0.0) return approach_speed * decay * std::sin(root * t) / root;
    double const slow = std::exp((root - decay_rate_) * t);
    double const fast = std::exp(-(root + decay_rate_) * t);
    return approach_speed * (slow - fast) / (2.0 * root);
  }

 private:
  static constexpr double pi_ = 3.14159265358979323846;
  double decay_rate_;         ///< beta, [1 / tau_e]
  double frequency_squared_;  ///< Omega^2, [1 / tau_e^2]; negative: overdamped
};

}  // namespace bagnold::reference
