// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// Real grains, in SI.
struct Grains {
  double diameter;           ///< of the small ones, [m]
  double density;            ///< [kg/m^3]
  double modulus;            ///< Young's, [Pa]
  double poisson = 0.3;      ///< Poisson's number
  double speed = 0.1;        ///< at which two meet, [m/s]
  double restitution = 0.9;  ///< of a head-on collision, 0 < e < 1
};

/// A scene's units of such grains, in SI, and the damping that gives their restitution.
struct GrainUnits {
  double grain_mass;  ///< of a small one, [kg]
  double duration;    ///< of a collision, [s]
  double elasticity;  ///< Q
  double time;        ///< tau_e, [s]
  double mass;        ///< m, [kg]

  double pressure() const { return mass / (time * time); }  ///< m/tau_e^2, [N/m]
};

/// Spheres collide as Hertz has it, 2.87 (m_*^2 / (R_* E_*^2 v))^(1/5), m_* and R_* half of those
/// of a sphere, E_* = E / 2(1 - nu^2) (Landau and Lifshitz, Theory of Elasticity, Sec. 9); two
/// small disks of the mass M as a damped oscillator, for as long as pi/omega, e = exp(-beta
/// pi/omega), beta = 1/(M Q), omega^2 = 2/M - beta^2 (P1 Eq. 7). disk_mass: M, 1 or, by area, pi/2.
GrainUnits units_of(Grains const& grains, double disk_mass);

}  // namespace bagnold
