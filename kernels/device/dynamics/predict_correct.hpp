// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/device/dynamics/device_step.hpp"
#include "kernels/device/dynamics/list_renewal.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "kernels/physics/schemes/forms.hpp"

namespace bagnold {

/// dt/m and dt/I of a disk.
struct TimePerMass {
  Real mass, inertia;

  KOKKOS_FUNCTION TimePerMass(Real time, SpeciesTable const& table, Species species)
      : mass(time * table.inverse_mass[species]), inertia(time * table.inverse_inertia[species]) {}
};

/// First half of the step of a PredictCorrectScheme: the trial state.
template <ContactLaw Law, class Repulsion, class Space, PredictCorrectScheme Scheme>
struct Predict {
  ContactForces<Law, Repulsion, Space> forces;  ///< at t
  Real time_step;                               ///< dt, [tau_e]
  Kokkos::View<Vec2<Real>*, Space> trial_position;
  Kokkos::View<Motion<Law::rotates>*, Space> trial_motion;

  KOKKOS_FUNCTION void operator()(std::uint32_t i) const {
    auto const before = forces.motion(i);
    auto const load = forces(i, NoObserver{});
    TimePerMass const per(time_step, forces.table, forces.species(i));
    Motion<Law::rotates> trial;
    trial.velocity = Scheme::trial_velocity(before.velocity, load.force, per.mass);
    if constexpr (Law::rotates)
      trial.spin = Scheme::trial_velocity(before.spin, load.torque, per.inertia);
    trial_position(i) = Scheme::trial_position(forces.position(i), before.velocity, time_step);
    trial_motion(i) = trial;
  }
};

/// Notes an overlap too large to be physics.
struct OverlapLimit {
  bool exceeded = false;
  KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair) {
    exceeded = exceeded || pair.relative_overlap > largest_relative_overlap;
  }
};

/// Second half of its step. Reduces (Max) the largest |w|^2 of r_1 and of the next
/// trial position r_1 + v_1 dt, so that the list can be renewed before it is outrun; infinity where
/// a motion is NaN or an overlap is beyond its limit.
template <ContactLaw Law, class Repulsion, class Space, PredictCorrectScheme Scheme>
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
    auto const load = forces(i, limit);
    auto const before = motion(i), trial = forces.motion(i);
    TimePerMass const half(time_step / 2, forces.table, forces.species(i));
    Motion<Law::rotates> after;
    after.velocity = Scheme::velocity(before.velocity, trial.velocity, load.force, half.mass);
    if constexpr (Law::rotates)
      after.spin = Scheme::velocity(before.spin, trial.spin, load.torque, half.inertia);
    auto const moved =
        Scheme::position(position(i), before.velocity, after.velocity, time_step / 2);
    motion(i) = after;
    position(i) = moved;

    keep_largest(
        largest, nonaffine2(moved, at_build(i), strain_since_build),
        nonaffine2(flown(moved, after.velocity, time_step), at_build(i), next_strain_since_build),
        !limit.exceeded);
  }
};

/// The form as a SteppedSystem takes it. Trial Views hold the trial state.
template <PredictCorrectScheme Scheme>
struct DeviceStep<Scheme> {
  template <class System>
  KOKKOS_FUNCTION static auto measured_forces(System const& system, ShearedBox const& box) {
    return system.forces(box);
  }

  template <class Law, class Repulsion, class Space, class Loops>
  KOKKOS_FUNCTION static bool begin(SteppedSystem<Law, Repulsion, Space, Scheme> const& system,
                                    Loops const& loops, ShearedBox const& box) {
    auto const& disks = system.disks;
    loops.for_all("dynamics::Predict", disks.count(),
                  Predict<Law, Repulsion, Space, Scheme>{system.forces(box), system.time_step,
                                                         disks.trial_position, disks.trial_motion});
    return true;
  }

  template <class Law, class Repulsion, class Space, class Loops>
  KOKKOS_FUNCTION static Real end(SteppedSystem<Law, Repulsion, Space, Scheme>& system,
                                  Loops const& loops, ShearedBox const&, ShearedBox const& next_box,
                                  Real strain, Real next_strain) {
    auto const& disks = system.disks;
    Real largest2 = 0;
    loops.reduce(
        "dynamics::Correct", disks.count(),
        Correct<Law, Repulsion, Space, Scheme>{
            system.forces(next_box, disks.trial_position, disks.trial_motion), system.time_step,
            disks.position, disks.motion, disks.at_build, strain, next_strain},
        Kokkos::Max<Real>(largest2));
    return largest2;
  }
};

}  // namespace bagnold
