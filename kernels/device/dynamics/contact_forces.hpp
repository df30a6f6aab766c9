// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/device/neighbors/neighbor_rows.hpp"
#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/motion.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Sees no pair.
struct NoObserver {
  KOKKOS_FUNCTION void operator()(PairForce<Real> const&) const {}
};

/// Powers of what acts on one disk in a step, beyond those that its pairs show, [m d_s^2 /
/// tau_e^3].
struct DiskPower {
  Real dissipation = 0;  ///< leaves the motion
  Real torque = 0;       ///< goes into the rotation
};

/// The force on one disk from all disks it touches: images, cutoff, repulsion, torque and sum are
/// here and nowhere else; the law and the repulsion say only what they differ in.
///
/// Each disk sums its own contacts in the order of its row (by neighbour index), so the bits depend
/// neither on threads nor on when the list was built. r_ij and r_ji are exact negatives: so are
/// their forces.
template <PairLaw Law, class Repulsion, class Space>
struct ContactForces {
  static constexpr bool rotates = Law::rotates;

  Kokkos::View<Vec2<Real> const*, Space> position;     ///< [N], [d_s]
  Kokkos::View<Motion<rotates> const*, Space> motion;  ///< [N]
  Kokkos::View<Species const*, Space> species;         ///< [N]
  NeighborRows<Space> neighbors;
  SpeciesTable table;
  ShearedBox box;  ///< at the time of position and motion
  Law law;
  Repulsion repulsion;

  template <class Observer>
  KOKKOS_FUNCTION Load<rotates> operator()(std::uint32_t i, Observer&& observe) const {
    Load<rotates> total;
    Real const diameter_i = table.diameter[species(i)];
    each_contact(i, [&](std::uint32_t, Vec2<Real> const& separation, Real distance2,
                        Real inverse_distance, Vec2<Real> const& velocity, Real spins) {
      auto const pair =
          pair_force(law, repulsion, separation, distance2, velocity, inverse_distance, spins);
      total.force += pair.elastic + pair.dissipative;
      if constexpr (rotates)
        total.torque += diameter_i * pair.torque_per_diameter(inverse_distance);
      observe(pair);
    });
    return total;
  }

  /// Of i, whose pairs the observer sees.
  template <class Observer>
  KOKKOS_FUNCTION DiskPower power(std::uint32_t i, Observer&& observe) const {
    auto const load = (*this)(i, observe);
    DiskPower power;
    if constexpr (rotates) power.torque = load.torque * motion(i).spin;
    return power;
  }

  /// The configuration.
  KOKKOS_FUNCTION ContactForces const& now() const { return *this; }

  /// visit(j, r_ij, r_ij^2, 1/d_ij, v_ij, thetadot_i d_i + thetadot_j d_j) for all disks j that i
  /// touches.
  template <class Visit>
  KOKKOS_FUNCTION void each_contact(std::uint32_t i, Visit const& visit) const {
    Vec2<Real> const position_i = position(i);
    Motion<rotates> const motion_i = motion(i);
    Real const diameter_i = table.diameter[species(i)];

    for (auto k = neighbors.begin(i); k < neighbors.end(i); ++k) {
      Neighbor const neighbor = neighbors.entry(k);
      std::uint32_t const j = neighbor.index();
      Image const image = neighbor.image();
      Vec2<Real> const separation = (position_i - position(j)) - box.shift(image);
      Real const diameter_j = table.diameter[species(j)];
      Real const contact_distance = (diameter_i + diameter_j) / 2;
      Real const distance2 = dot(separation, separation);
      if (distance2 >= contact_distance * contact_distance) continue;

      Motion<rotates> const motion_j = motion(j);
      Vec2<Real> velocity = motion_i.velocity - motion_j.velocity;
      velocity.x -= box.velocity_shift(image);
      Real const inverse_distance = 1 / contact_distance;
      Real spins = 0;
      if constexpr (rotates) spins = motion_i.spin * diameter_i + motion_j.spin * diameter_j;
      visit(j, separation, distance2, inverse_distance, velocity, spins);
    }
  }
};

}  // namespace bagnold
