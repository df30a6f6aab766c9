// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/device/dynamics/device_step.hpp"
#include "kernels/device/dynamics/disk_views.hpp"
#include "kernels/device/dynamics/list_renewal.hpp"
#include "kernels/device/dynamics/predict_correct.hpp"
#include "kernels/device/system_table.hpp"
#include "kernels/physics/schemes/chebyshev.hpp"
#include "kernels/physics/schemes/damping_bound.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Change by the forces, a of an ImplicitScheme. Reduces (Max) the rate of damping that the
/// contacts of one disk bound; infinity where disks overlap too much.
template <ContactLaw Law, class Repulsion, class Space, ImplicitScheme Scheme>
struct ImplicitStart {
  ContactForces<Law, Repulsion, Space> forces;  ///< at t
  Real time_step;                               ///< dt, [tau_e]
  Kokkos::View<Motion<Law::rotates>*, Space> change;
  Kokkos::View<DampingBound const*, Space> bound;  ///< [1]

  struct Counter {
    int& contacts;
    bool& too_deep;
    KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair) const {
      ++contacts;
      too_deep = too_deep || pair.relative_overlap > largest_relative_overlap;
    }
  };

  KOKKOS_FUNCTION void operator()(std::uint32_t i, Real& largest) const {
    int count = 0;
    bool too_deep = false;
    auto const load = forces(i, Counter{count, too_deep});
    TimePerMass const per(time_step, forces.table, forces.species(i));
    Motion<Law::rotates> changed;
    changed.velocity = Scheme::change(load.force, per.mass);
    if constexpr (Law::rotates) changed.spin = Scheme::change(load.torque, per.inertia);
    change(i) = changed;
    Real const rate =
        too_deep ? Kokkos::reduction_identity<Real>::min() : bound(0)(forces.species(i), count);
    if (rate > largest) largest = rate;
  }
};

/// The damping of contacts at t where disks move with given velocities and spins instead of theirs.
template <ContactLaw Law, class Repulsion, class Space>
struct DampingForces {
  static constexpr bool rotates = Law::rotates;
  ContactForces<Law, Repulsion, Space> forces;
  Kokkos::View<Motion<rotates> const*, Space> moving;

  /// visit(pair, contact at the velocities of `moving`, velocity at the contact as it is)
  template <class Visit>
  KOKKOS_FUNCTION void each_contact(std::uint32_t i, Visit const& visit) const {
    Real const diameter_i = forces.table.diameter[forces.species(i)];
    forces.each_contact(i, [&](Neighbor neighbor, Vec2<Real> const& separation, Real distance2,
                               Real inverse_distance, Vec2<Real> const& velocity, Real spins) {
      auto const at_contact = [&](Vec2<Real> const& of_centres, Real of_spins) {
        return velocity_at_contact<Law>(of_centres, separation, inverse_distance, of_spins);
      };
      auto const j = neighbor.index();
      Real moving_spins = 0;
      if constexpr (rotates) {
        Real const diameter_j = forces.table.diameter[neighbor.big()];
        moving_spins = moving(i).spin * diameter_i + moving(j).spin * diameter_j;
      }
      Contact<Real> contact = make_contact(separation, distance2, inverse_distance);
      contact.velocity = at_contact(moving(i).velocity - moving(j).velocity, moving_spins);
      visit(separation, contact, at_contact(velocity, spins));
    });
  }

  KOKKOS_FUNCTION void add(std::uint32_t i, PairForce<Real> const& pair,
                           Contact<Real> const& contact, Load<rotates>& to) const {
    to.force += pair.dissipative;
    if constexpr (rotates)
      to.torque += forces.table.diameter[forces.species(i)] *
                   pair.torque_per_diameter(contact.inverse_distance);
  }

  KOKKOS_FUNCTION Load<rotates> operator()(std::uint32_t i) const {
    Load<rotates> total;
    each_contact(
        i, [&](Vec2<Real> const& separation, Contact<Real> const& contact, Vec2<Real> const&) {
          add(i, {separation, {}, forces.law.dissipative_force(contact), {}, {}}, contact, total);
        });
    return total;
  }
};

/// One iteration for w.
template <ContactLaw Law, class Repulsion, class Space>
struct DampingIteration {
  DampingForces<Law, Repulsion, Space> damping;  ///< moving: u, w as far as it is known
  ChebyshevIteration iteration;
  Real weighed_time_step;                                  ///< theta dt, [tau_e]
  Kokkos::View<Motion<Law::rotates> const*, Space> start;  ///< a
  Kokkos::View<Motion<Law::rotates>*, Space> next;         ///< w_k+1

  KOKKOS_FUNCTION void operator()(std::uint32_t i) const {
    auto const load = damping(i);
    TimePerMass const per(weighed_time_step, damping.forces.table, damping.forces.species(i));
    auto const a = start(i), now = damping.moving(i);
    Motion<Law::rotates> w;
    w.velocity = iteration(a.velocity, load.force, per.mass, now.velocity);
    if constexpr (Law::rotates) w.spin = iteration(a.spin, load.torque, per.inertia, now.spin);
    next(i) = w;
  }
};

/// The forces of a step, as its sums have them: elastic at t, the damping that of v_- + theta w;
/// pairs are shown the velocity halfway, v_- + w/2. What iterations leave of the equation acts on
/// disks and not between pairs,
///
///     f_i = -(m_i/dt) (a_i - w_i + (theta dt/m_i) f_dis,i(w)),
///
/// and power() adds its part of what leaves the motion, -f_i . (v_- + w/2).
template <ContactLaw Law, class Repulsion, class Space, ImplicitScheme Scheme>
struct ImplicitForces {
  static constexpr bool rotates = Law::rotates;
  DampingForces<Law, Repulsion, Space> damping;  ///< moving: w
  Kokkos::View<Motion<rotates> const*, Space> start;
  Real time_step;  ///< dt, [tau_e]

  KOKKOS_FUNCTION ContactForces<Law, Repulsion, Space> const& now() const { return damping.forces; }

  template <class Observer>
  KOKKOS_FUNCTION DiskPower power(std::uint32_t i, Observer&& observe) const {
    auto const& forces = damping.forces;
    Real const theta = Scheme::theta;
    Load<rotates> load;
    damping.each_contact(
        i, [&](Vec2<Real> const& separation, Contact<Real> contact, Vec2<Real> const& velocity) {
          damping.add(i, {separation, {}, forces.law.dissipative_force(contact), {}, {}}, contact,
                      load);
          auto const halfway = velocity + Real(0.5) * contact.velocity;
          contact.velocity = velocity + theta * contact.velocity;
          observe(force_of_contact(forces.law, forces.repulsion, separation, contact, halfway));
        });
    auto const species = forces.species(i);
    auto const before = forces.motion(i), change = damping.moving(i);
    TimePerMass const per(theta * time_step, forces.table, species);
    auto const left = start(i).velocity - change.velocity + per.mass * load.force;
    Real const ux = peculiar_x(before.velocity.x, forces.position(i).y, forces.box.strain_rate);
    Vec2<Real> const halfway = Vec2<Real>{ux, before.velocity.y} + Real(0.5) * change.velocity;
    DiskPower power;
    power.dissipation = dot(left, halfway) / (time_step * forces.table.inverse_mass[species]);
    if constexpr (rotates) {
      Real const inertia_rate = 1 / (time_step * forces.table.inverse_inertia[species]);
      Real const spin = before.spin + Real(0.5) * change.spin;
      power.dissipation +=
          (start(i).spin - change.spin + per.inertia * load.torque) * spin * inertia_rate;
      power.torque = change.spin * spin * inertia_rate;
    }
    return power;
  }
};

/// The step once w is known. Reduces (Max) as Correct does.
template <ContactLaw Law, class Space, ImplicitScheme Scheme>
struct ImplicitLeap {
  Kokkos::View<Motion<Law::rotates> const*, Space> change;  ///< w
  Real time_step;                                           ///< dt, [tau_e]
  Kokkos::View<Vec2<Real>*, Space> position;
  Kokkos::View<Motion<Law::rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> at_build;
  Real strain_since_build;       ///< at t + dt
  Real next_strain_since_build;  ///< at t + 2 dt

  KOKKOS_FUNCTION void operator()(std::uint32_t i, Real& largest) const {
    auto after = motion(i);
    after.velocity = Scheme::velocity(after.velocity, change(i).velocity);
    if constexpr (Law::rotates) after.spin = Scheme::velocity(after.spin, change(i).spin);
    auto const moved = Scheme::position(position(i), after.velocity, time_step);
    motion(i) = after;
    position(i) = moved;
    keep_largest(
        largest, nonaffine2(moved, at_build(i), strain_since_build),
        nonaffine2(flown(moved, after.velocity, time_step), at_build(i), next_strain_since_build),
        true);
  }
};

template <class Space, LinearLaw Law>
Kokkos::View<DampingBound*, Space> bound_on_device(Law const& law, SpeciesTable const& table) {
  Kokkos::View<DampingBound*, Space> const bound("dynamics::damping_bound", 1);
  Kokkos::deep_copy(bound, DampingBound::of(law, table));
  return bound;
}

/// Views of implicit steps: two targets of iterations, in turns, the bound, and the roots.
template <bool Rotates, ImplicitScheme Scheme, class Space>
struct StepViews<Rotates, Scheme, Space> {
  Kokkos::View<Motion<Rotates>*, Space> iterate[2];  ///< [N]
  Kokkos::View<DampingBound const*, Space> bound;    ///< [1]
  ChebyshevRoots roots;

  template <class Law>
  void allocate(Law const& law, SpeciesTable const& table, Real, std::size_t disks) {
    for (auto& each : iterate)
      each = Kokkos::View<Motion<Rotates>*, Space>("dynamics::iterate", disks);
    bound = bound_on_device<Space>(law, table);
    roots = ChebyshevRoots::make(Scheme::terms(Law::rotates), Scheme::lift);
  }
};

template <bool Rotates, ImplicitScheme Scheme, class Space>
struct StepTables<Rotates, Scheme, Space> {
  SystemTable<Motion<Rotates>, Space> iterate[2];
  Kokkos::View<DampingBound*, Space> bound;
  ChebyshevRoots roots;

  KOKKOS_FUNCTION StepViews<Rotates, Scheme, Space> of(std::size_t s) const {
    return {{part(iterate[0], s), part(iterate[1], s)},
            Kokkos::View<DampingBound const*, Space>(bound.data(), 1),
            roots};
  }

  template <class Law>
  void allocate(Law const& law, SpeciesTable const& table, Real, std::size_t systems,
                std::size_t disks) {
    for (auto& each : iterate)
      each = SystemTable<Motion<Rotates>, Space>("dynamics::iterate", systems, disks);
    bound = bound_on_device<Space>(law, table);
    roots = ChebyshevRoots::make(Scheme::terms(Law::rotates), Scheme::lift);
  }
};

/// The form as a SteppedSystem takes it. Trial motions hold what the forces change.
template <ImplicitScheme Scheme>
struct DeviceStep<Scheme> {
  /// Through the contacts.
  template <class Law>
  static constexpr int passes = Scheme::terms(Law::rotates) - 1;
  /// Index of the iterate that is w.
  template <class Law>
  static constexpr int solution = (passes<Law> - 1) % 2;

  template <class Law, class Repulsion, class Space>
  KOKKOS_FUNCTION static ImplicitForces<Law, Repulsion, Space, Scheme> measured_forces(
      SteppedSystem<Law, Repulsion, Space, Scheme> const& system, ShearedBox const& box) {
    auto const& disks = system.disks;
    return {{system.forces(box), disks.step.iterate[solution<Law>]},
            disks.trial_motion,
            system.time_step};
  }

  template <class Law, class Repulsion, class Space, class Loops>
  KOKKOS_FUNCTION static bool begin(SteppedSystem<Law, Repulsion, Space, Scheme> const& system,
                                    Loops const& loops, ShearedBox const& box) {
    auto const& disks = system.disks;
    auto const forces = system.forces(box);
    Real rate = 0;
    loops.reduce("dynamics::ImplicitStart", disks.count(),
                 ImplicitStart<Law, Repulsion, Space, Scheme>{forces, system.time_step,
                                                              disks.trial_motion, disks.step.bound},
                 Kokkos::Max<Real>(rate));
    if (!(rate < Kokkos::reduction_identity<Real>::min())) return false;
    Real const weighed = Scheme::theta * system.time_step;
    ChebyshevIterations const iterations(weighed * rate, disks.step.roots);
    auto now = disks.trial_motion;
    for (int k = 0; k < passes<Law>; ++k) {
      auto const next = disks.step.iterate[k % 2];
      loops.for_all("dynamics::DampingIteration", disks.count(),
                    DampingIteration<Law, Repulsion, Space>{
                        {forces, now}, iterations.iteration[k], weighed, disks.trial_motion, next});
      now = next;
    }
    return true;
  }

  template <class Law, class Repulsion, class Space, class Loops>
  KOKKOS_FUNCTION static Real end(SteppedSystem<Law, Repulsion, Space, Scheme>& system,
                                  Loops const& loops, ShearedBox const&, ShearedBox const&,
                                  Real strain, Real next_strain) {
    auto const& disks = system.disks;
    Real largest2 = 0;
    loops.reduce("dynamics::ImplicitLeap", disks.count(),
                 ImplicitLeap<Law, Space, Scheme>{disks.step.iterate[solution<Law>],
                                                  system.time_step, disks.position, disks.motion,
                                                  disks.at_build, strain, next_strain},
                 Kokkos::Max<Real>(largest2));
    return largest2;
  }
};

}  // namespace bagnold
