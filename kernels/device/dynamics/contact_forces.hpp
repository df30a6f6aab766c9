// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <type_traits>

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

  /// An observer is shown each pair, and the neighbour if it asks for it.
  template <class Observer>
  KOKKOS_FUNCTION Load<rotates> operator()(std::uint32_t i, Observer&& observe) const {
    Load<rotates> total;
    Real const diameter_i = table.diameter[species(i)];
    each_contact(i, [&](Neighbor neighbor, Vec2<Real> const& separation, Real distance2,
                        Real inverse_distance, Vec2<Real> const& velocity, Real spins) {
      auto const pair =
          pair_force(law, repulsion, separation, distance2, velocity, inverse_distance, spins);
      total.force += pair.elastic + pair.dissipative;
      if constexpr (rotates)
        total.torque += diameter_i * pair.torque_per_diameter(inverse_distance);
      if constexpr (std::is_invocable_v<Observer, PairForce<Real> const&, Neighbor>)
        observe(pair, neighbor);
      else
        observe(pair);
    });
    return total;
  }

  /// Power of the forces on disk i; the observer sees its pairs.
  template <class Observer>
  KOKKOS_FUNCTION DiskPower power(std::uint32_t i, Observer&& observe) const {
    auto const load = (*this)(i, observe);
    DiskPower power;
    if constexpr (rotates) power.torque = load.torque * motion(i).spin;
    return power;
  }

  /// The configuration.
  KOKKOS_FUNCTION ContactForces const& now() const { return *this; }

  /// visit(neighbour j, r_ij, r_ij^2, 1/d_ij, v_ij, thetadot_i d_i + thetadot_j d_j) for all disks
  /// j that i touches.
  template <class Visit>
  KOKKOS_FUNCTION void each_contact(std::uint32_t i, Visit const& visit) const {
    Own const own = own_of(i);
    for (auto k = neighbors.begin(i); k < neighbors.end(i); ++k) {
      Neighbor const neighbor = neighbors.entry(k);
      Vec2<Real> const separation = separation_from(own, neighbor);
      Real const distance2 = dot(separation, separation);
      Real const reach = class_distance(own.pair_class_with(neighbor));
      if (distance2 < reach * reach) show(own, neighbor, separation, distance2, visit);
    }
  }

  /// visit(neighbour j, whether i touches it, r_ij, 1/d_ij, v_ij, thetadot_i d_i + thetadot_j d_j)
  /// for the neighbours j of i for which wanted(index of j, whether i touches it) is true.
  template <class Wanted, class Visit>
  KOKKOS_FUNCTION void each_neighbor(std::uint32_t i, Wanted const& wanted,
                                     Visit const& visit) const {
    Own const own = own_of(i);
    for (auto k = neighbors.begin(i); k < neighbors.end(i); ++k) {
      Neighbor const neighbor = neighbors.entry(k);
      Vec2<Real> const separation = separation_from(own, neighbor);
      Real const distance2 = dot(separation, separation);
      Real const reach = class_distance(own.pair_class_with(neighbor));
      bool const touching = distance2 < reach * reach;
      if (!wanted(neighbor.index(), touching)) continue;
      show(own, neighbor, separation, distance2,
           [&](Neighbor j, Vec2<Real> const& r, Real, Real inverse_distance, Vec2<Real> const& v,
               Real spins) { visit(j, touching, r, inverse_distance, v, spins); });
    }
  }

  /// Visits the disks that i is known to touch: touching(k), k < count.
  template <class Touching, class Visit>
  KOKKOS_FUNCTION void each_of(std::uint32_t i, int count, Touching const& touching,
                               Visit const& visit) const {
    Own const own = own_of(i);
    for (int k = 0; k < count; ++k) {
      Neighbor const neighbor = touching(k);
      Vec2<Real> const separation = separation_from(own, neighbor);
      show(own, neighbor, separation, dot(separation, separation), visit);
    }
  }

 private:
  struct Own {
    Vec2<Real> position;
    Motion<rotates> motion;
    Species species;

    KOKKOS_FUNCTION int pair_class_with(Neighbor neighbor) const {
      return pair_class(species, neighbor.big());
    }
  };

  KOKKOS_FUNCTION Own own_of(std::uint32_t i) const { return {position(i), motion(i), species(i)}; }

  KOKKOS_FUNCTION Vec2<Real> separation_from(Own const& own, Neighbor neighbor) const {
    return (own.position - position(neighbor.index())) - box.shift(neighbor.image());
  }

  template <class Visit>
  KOKKOS_FUNCTION void show(Own const& own, Neighbor neighbor, Vec2<Real> const& separation,
                            Real distance2, Visit const& visit) const {
    Motion<rotates> const other = motion(neighbor.index());
    Vec2<Real> velocity = own.motion.velocity - other.velocity;
    velocity.x -= box.velocity_shift(neighbor.image());
    Real spins = 0;
    if constexpr (rotates)
      spins = own.motion.spin * table.diameter[own.species] +
              other.spin * table.diameter[neighbor.big()];
    visit(neighbor, separation, distance2, inverse_class_distance(own.pair_class_with(neighbor)),
          velocity, spins);
  }
};

}  // namespace bagnold
