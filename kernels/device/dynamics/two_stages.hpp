// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/device/dynamics/device_step.hpp"
#include "kernels/device/dynamics/disk_views.hpp"
#include "kernels/device/dynamics/list_renewal.hpp"
#include "kernels/device/dynamics/predict_correct.hpp"
#include "kernels/device/system_table.hpp"
#include "kernels/physics/schemes/second_stage.hpp"

namespace bagnold {

/// Contacts of each disk as the first stage of a step finds them, for the second stage and for
/// sums: how many, and with whom, as far as there is room. Entry k of all disks lies side by side,
/// so that threads side by side read side by side.
template <class Space>
struct TouchingDisks {
  static constexpr int room = 8;  ///< a disk with more contacts is searched for again

  Kokkos::View<int*, Space> count;           ///< [N]
  Kokkos::View<Neighbor*, Space> neighbors;  ///< [room N]

  KOKKOS_FUNCTION Neighbor& of(std::uint32_t i, int k) const {
    return neighbors(static_cast<std::size_t>(k) * count.extent(0) + i);
  }
};

/// First stage of a TwoStageScheme: what the forces change, and which disks touch.
template <ContactLaw Law, class Repulsion, class Space, TwoStageScheme Scheme>
struct FirstStage {
  ContactForces<Law, Repulsion, Space> forces;  ///< at t
  Real time_step;                               ///< dt, [tau_e]
  Kokkos::View<Motion<Law::rotates>*, Space> change;
  TouchingDisks<Space> touching;

  struct Lister {
    TouchingDisks<Space> const& touching;
    std::uint32_t disk;
    int& count;
    bool& too_deep;
    KOKKOS_FUNCTION void operator()(PairForce<Real> const& pair, Neighbor neighbor) const {
      if (count < TouchingDisks<Space>::room) touching.of(disk, count) = neighbor;
      ++count;
      too_deep = too_deep || pair.relative_overlap > largest_relative_overlap;
    }
  };

  /// Counts in `failed` disks that overlap another one too much.
  KOKKOS_FUNCTION void operator()(std::uint32_t i, Real& failed) const {
    int count = 0;
    bool too_deep = false;
    auto const load = forces(i, Lister{touching, i, count, too_deep});
    TimePerMass const per(time_step, forces.table, forces.species(i));
    Motion<Law::rotates> changed;
    changed.velocity = Scheme::change(load.force, per.mass);
    if constexpr (Law::rotates) changed.spin = Scheme::change(load.torque, per.inertia);
    change(i) = changed;
    touching.count(i) = count;
    if (too_deep) failed = 1;
  }
};

/// The damping of the changes. Observers see the forces of both stages together, and the velocity
/// halfway through the step, but for what second stages change of it, which power() adds up disk by
/// disk:
///
///     sum_pairs f_ij . (b_i - b_j) = sum_i f_i . b_i,   f: the damping of both stages
///
/// and the same with torques and spins.
template <ContactLaw Law, class Repulsion, class Space>
struct ChangeForces {
  static constexpr bool rotates = Law::rotates;
  ContactForces<Law, Repulsion, Space> forces;  ///< at t
  Kokkos::View<Motion<rotates> const*, Space> change;
  TouchingDisks<Space> touching;
  Kokkos::View<SecondStage const*, Space> shares;  ///< [1]: looked up by index, so in memory
  Real time_step;                                  ///< dt, [tau_e]

  KOKKOS_FUNCTION ContactForces<Law, Repulsion, Space> const& now() const { return forces; }

  template <class Observer>
  KOKKOS_FUNCTION Load<rotates> operator()(std::uint32_t i, Observer&& observe) const {
    return damping(i, observe).second;
  }

  /// As ContactForces has it, of the whole step.
  template <class Observer>
  KOKKOS_FUNCTION DiskPower power(std::uint32_t i, Observer&& observe) const {
    return power_of_damping(i, damping(i, observe));
  }

  /// On one disk, of the second stage and of both.
  struct Damping {
    Load<rotates> second, both;
  };

  KOKKOS_FUNCTION DiskPower power_of_damping(std::uint32_t i, Damping const& damping) const {
    auto const& [second, both] = damping;
    auto const species = forces.species(i);
    Real const half_per_mass = time_step / 2 * forces.table.inverse_mass[species];
    DiskPower power{-half_per_mass * dot(both.force, second.force), 0};
    if constexpr (rotates) {
      Real const half_per_inertia = time_step / 2 * forces.table.inverse_inertia[species];
      power.dissipation -= half_per_inertia * both.torque * second.torque;
      power.torque = both.torque * (forces.motion(i).spin + half_per_inertia * both.torque);
    }
    return power;
  }

  template <class Observer>
  KOKKOS_FUNCTION Damping damping(std::uint32_t i, Observer&& observe) const {
    Damping total;
    Species const own = forces.species(i);
    Real const diameter_i = forces.table.diameter[own];
    Motion<rotates> const change_i = change(i);
    int const contacts_i = touching.count(i);
    auto const visit = [&](Neighbor neighbor, Vec2<Real> const& separation, Real distance2,
                           Real inverse_distance, Vec2<Real> const& velocity, Real spins) {
      auto const j = neighbor.index();
      Real const diameter_j = forces.table.diameter[neighbor.big()];
      Motion<rotates> const change_j = change(j);
      auto const at_contact = [&](Vec2<Real> const& of_centres, Real of_spins) {
        return velocity_at_contact<Law>(of_centres, separation, inverse_distance, of_spins);
      };
      Real changed_spins = 0;
      if constexpr (rotates)
        changed_spins = change_i.spin * diameter_i + change_j.spin * diameter_j;
      auto const changed = at_contact(change_i.velocity - change_j.velocity, changed_spins);
      auto const before = at_contact(velocity, spins);
      int const contacts_j = touching.count(j);
      int const n = SecondStage::index(contacts_i > contacts_j ? contacts_i : contacts_j);
      int const c = pair_class(own, neighbor.big());
      SecondStage const& share = shares(0);
      auto const contact =
          second_stage_contact<Law>(separation, distance2, inverse_distance, changed,
                                    share.normal[c][n], share.tangential[c][n]);
      auto const both =
          force_of_both_stages(forces.law, forces.repulsion, separation, contact, before, changed);
      auto const add = [&](PairForce<Real> const& pair, Load<rotates>& to) {
        to.force += pair.dissipative;
        if constexpr (rotates) to.torque += diameter_i * pair.torque_per_diameter(inverse_distance);
      };
      add({separation, {}, forces.law.dissipative_force(contact), {}, {}}, total.second);
      add(both, total.both);
      observe(both);
    };
    if (contacts_i <= TouchingDisks<Space>::room)
      forces.each_of(
          i, contacts_i, [&](int k) { return touching.of(i, k); }, visit);
    else
      forces.each_contact(i, visit);
    return total;
  }
};

/// The damping of the changes where a drive's second stage changes velocities too.
template <class Law, class Repulsion, class Space>
struct DrivenChangeForces {
  using Forces = ChangeForces<Law, Repulsion, Space>;
  static constexpr bool rotates = Law::rotates;
  Forces forces;
  Kokkos::View<Motion<rotates> const*, Space> driven;  ///< what the drag of the changes changes

  KOKKOS_FUNCTION ContactForces<Law, Repulsion, Space> const& now() const { return forces.now(); }

  template <class Observer>
  KOKKOS_FUNCTION DiskPower power(std::uint32_t i, Observer&& observe) const {
    auto const damping = forces.damping(i, observe);
    DiskPower power = forces.power_of_damping(i, damping);
    power.dissipation -= Real(0.5) * dot(damping.both.force, driven(i).velocity);
    if constexpr (rotates) power.dissipation -= Real(0.5) * damping.both.torque * driven(i).spin;
    return power;
  }
};

/// Second stage, and the step. Reduces (Max) as Correct does; new positions go to another array, as
/// neighbours still read the old ones.
template <ContactLaw Law, class Repulsion, class Space, TwoStageScheme Scheme>
struct LeapOn {
  ChangeForces<Law, Repulsion, Space> forces;
  Real time_step;  ///< dt, [tau_e]
  Kokkos::View<Vec2<Real>*, Space> next_position;
  Kokkos::View<Motion<Law::rotates>*, Space> motion;
  Kokkos::View<Vec2<Real>*, Space> at_build;
  Real strain_since_build;       ///< at t + dt
  Real next_strain_since_build;  ///< at t + 2 dt

  KOKKOS_FUNCTION void operator()(std::uint32_t i, Real& largest) const {
    auto const& now = forces.now();
    auto const before = motion(i), change = forces.change(i);
    auto const second = forces(i, NoObserver{});
    TimePerMass const per(time_step, now.table, now.species(i));
    Motion<Law::rotates> after;
    after.velocity = Scheme::velocity(before.velocity, change.velocity, second.force, per.mass);
    if constexpr (Law::rotates)
      after.spin = Scheme::velocity(before.spin, change.spin, second.torque, per.inertia);
    auto const moved = Scheme::position(now.position(i), after.velocity, time_step);
    motion(i) = after;
    next_position(i) = moved;
    keep_largest(
        largest, nonaffine2(moved, at_build(i), strain_since_build),
        nonaffine2(flown(moved, after.velocity, time_step), at_build(i), next_strain_since_build),
        true);
  }
};

template <class Scheme, class Space, TwoStageLaw Law>
Kokkos::View<SecondStage*, Space> shares_on_device(Law const& law, SpeciesTable const& table,
                                                   Real time_step) {
  Kokkos::View<SecondStage*, Space> const shares("dynamics::second_stage", 1);
  Kokkos::deep_copy(shares, SecondStage::of<Scheme>(law, table, time_step));
  return shares;
}

/// Who touches whom, and the shares of the second stage.
template <bool Rotates, TwoStageScheme Scheme, class Space>
struct StepViews<Rotates, Scheme, Space> {
  TouchingDisks<Space> touching;
  Kokkos::View<SecondStage const*, Space> shares;  ///< [1]

  template <class Law>
  void allocate(Law const& law, SpeciesTable const& table, Real time_step, std::size_t disks) {
    touching = {
        Kokkos::View<int*, Space>("dynamics::contacts", disks),
        Kokkos::View<Neighbor*, Space>("dynamics::touching", TouchingDisks<Space>::room * disks)};
    shares = shares_on_device<Scheme, Space>(law, table, time_step);
  }
};

template <bool Rotates, TwoStageScheme Scheme, class Space>
struct StepTables<Rotates, Scheme, Space> {
  SystemTable<int, Space> contacts;
  SystemTable<Neighbor, Space> touching;
  Kokkos::View<SecondStage*, Space> shares;

  KOKKOS_FUNCTION StepViews<Rotates, Scheme, Space> of(std::size_t s) const {
    return {{part(contacts, s), part(touching, s)},
            Kokkos::View<SecondStage const*, Space>(shares.data(), 1)};
  }

  template <class Law>
  void allocate(Law const& law, SpeciesTable const& table, Real time_step, std::size_t systems,
                std::size_t disks) {
    contacts = SystemTable<int, Space>("dynamics::contacts", systems, disks);
    touching = SystemTable<Neighbor, Space>("dynamics::touching", systems,
                                            TouchingDisks<Space>::room * disks);
    shares = shares_on_device<Scheme, Space>(law, table, time_step);
  }
};

/// The form as a SteppedSystem takes it. Trial Views hold the next positions and what the first
/// stage changes.
template <TwoStageScheme Scheme>
struct DeviceStep<Scheme> {
  template <class Law, class Repulsion, class Space>
  KOKKOS_FUNCTION static ChangeForces<Law, Repulsion, Space> measured_forces(
      SteppedSystem<Law, Repulsion, Space, Scheme> const& system, ShearedBox const& box) {
    auto const& disks = system.disks;
    return {system.forces(box), disks.trial_motion, disks.step.touching, disks.step.shares,
            system.time_step};
  }

  template <class Law, class Repulsion, class Space, class Loops>
  KOKKOS_FUNCTION static bool begin(SteppedSystem<Law, Repulsion, Space, Scheme> const& system,
                                    Loops const& loops, ShearedBox const& box) {
    auto const& disks = system.disks;
    Real failed = 0;
    loops.reduce("dynamics::FirstStage", disks.count(),
                 FirstStage<Law, Repulsion, Space, Scheme>{system.forces(box), system.time_step,
                                                           disks.trial_motion, disks.step.touching},
                 Kokkos::Max<Real>(failed));
    return !(failed > 0);
  }

  template <class Law, class Repulsion, class Space, class Loops>
  KOKKOS_FUNCTION static Real end(SteppedSystem<Law, Repulsion, Space, Scheme>& system,
                                  Loops const& loops, ShearedBox const& box, ShearedBox const&,
                                  Real strain, Real next_strain) {
    auto& disks = system.disks;
    Real largest2 = 0;
    loops.reduce("dynamics::LeapOn", disks.count(),
                 LeapOn<Law, Repulsion, Space, Scheme>{
                     measured_forces(system, box), system.time_step, disks.trial_position,
                     disks.motion, disks.at_build, strain, next_strain},
                 Kokkos::Max<Real>(largest2));
    auto const reached = disks.trial_position;
    disks.trial_position = disks.position;
    disks.position = reached;
    return largest2;
  }
};

}  // namespace bagnold
