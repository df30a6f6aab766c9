// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/physics/box/list_criterion.hpp"

namespace bagnold {

/// m + action dt, per mass and inertia: one kick of a disk.
template <bool Rotates>
KOKKOS_FUNCTION Motion<Rotates> kicked(Motion<Rotates> motion, Action<Rotates> const& action,
                                       Real time, SpeciesTable const& table, Species species) {
  motion.velocity += time * table.inverse_mass[species] * action.force;
  if constexpr (Rotates) motion.spin += time * table.inverse_inertia[species] * action.torque;
  return motion;
}

/// The halfway point of two motions.
template <bool Rotates>
KOKKOS_FUNCTION Motion<Rotates> mean(Motion<Rotates> const& a, Motion<Rotates> const& b) {
  Motion<Rotates> half;
  half.velocity = Real(0.5) * (a.velocity + b.velocity);
  if constexpr (Rotates) half.spin = Real(0.5) * (a.spin + b.spin);
  return half;
}

/// First half of the papers' step, P2 Eqs. (21)-(22), the same for the spin:
///
///     v~_1 = v_0 + f(r_0, v_0) dt/m,   r~_1 = r_0 + v_0 dt
template <ContactLaw Law, class Repulsion, class Space>
struct Predict {
  ContactForces<Law, Repulsion, Space> forces;  ///< at t
  Real time_step;                               ///< dt, [tau_e]
  Kokkos::View<Vec2<Real>*, Space> trial_position;
  Kokkos::View<Motion<Law::rotates>*, Space> trial_motion;

  KOKKOS_FUNCTION void operator()(std::uint32_t i) const {
    auto const motion = forces.motion(i);
    trial_position(i) = forces.position(i) + time_step * motion.velocity;
    trial_motion(i) =
        kicked(motion, forces(i, NoObserver{}), time_step, forces.table, forces.species(i));
  }
};

/// Notes an overlap too large to be physics.
struct OverlapLimit {
  bool exceeded = false;
  KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair) {
    exceeded = exceeded || pair.relative_overlap > largest_relative_overlap;
  }
};

/// Keeps the largest |w|^2 of a disk now and a step later; infinity where it is no number, or not sound.
KOKKOS_INLINE_FUNCTION void keep_largest(Real& largest, Real now2, Real next2, bool sound) {
  Real value = now2 > next2 ? now2 : next2;
  if (!(sound && value < Kokkos::reduction_identity<Real>::min() && now2 == now2))
    value = Kokkos::reduction_identity<Real>::min();
  if (value > largest) largest = value;
}

/// Second half, P2 Eqs. (23)-(24), with v_0 + f(r_0, v_0) dt/2m written as (v_0 + v~_1)/2:
///
///     v_1 = (v_0 + v~_1)/2 + f(r~_1, v~_1) dt/2m,   r_1 = r_0 + (v_0 + v_1) dt/2
///
/// A disk that touches nothing flies exactly r_0 + v dt. Reduces (Max) the largest |w|^2 of r_1 and
/// of the next trial position r_1 + v_1 dt, so that the list can be renewed before it is outrun;
/// infinity where a number is no number or an overlap is beyond its limit.
template <ContactLaw Law, class Repulsion, class Space>
struct Correct {
  ContactForces<Law, Repulsion, Space> forces;  ///< at the trial positions, at t + dt
  Real time_step;                               ///< dt, [tau_e]
  Kokkos::View<Vec2<Real>*, Space> position;
  Kokkos::View<Motion<Law::rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> at_build;
  Real strain_since_build;       ///< at t + dt
  Real next_strain_since_build;  ///< at t + 2 dt

  KOKKOS_FUNCTION void operator()(std::uint32_t i, Real& largest) const {
    OverlapLimit limit;
    auto const action = forces(i, limit);
    auto const before = motion(i);
    auto const after = kicked(mean(before, forces.motion(i)), action, time_step / 2, forces.table,
                              forces.species(i));
    Vec2<Real> const moved =
        position(i) + time_step / 2 * (before.velocity + after.velocity);
    motion(i) = after;
    position(i) = moved;

    keep_largest(largest, excursion2(moved, at_build(i), strain_since_build),
                 excursion2(moved + time_step * after.velocity, at_build(i),
                            next_strain_since_build),
                 !limit.exceeded);
  }
};

}  // namespace bagnold
