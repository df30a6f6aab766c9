// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/contact/contact.hpp"
#include "kernels/core/motion.hpp"
#include "kernels/core/species.hpp"
#include "kernels/geometry/sheared_box.hpp"
#include "kernels/neighbors/neighbor_rows.hpp"

namespace bagnold {

/// What a pair in contact exerts on i, and where: what observers of the pair loop are given.
struct PairForce {
  Vec2<Real> separation;   ///< r_ij = r_i - r_j, nearest image, [d_s]
  Vec2<Real> elastic;      ///< on i from j, [m d_s / tau_e^2]
  Vec2<Real> dissipative;  ///< on i from j, [m d_s / tau_e^2]
  Real relative_overlap;   ///< 1 - r_ij / d_ij
};

/// Watches no pair.
struct NoObserver {
  KOKKOS_FUNCTION void operator()(PairForce const&) const {}
};

/// The force on one disk from all disks it touches: images, cutoff, repulsion, torque and sum are
/// here and nowhere else; the law and the repulsion say only what they differ in.
///
/// Each disk sums its own contacts in the order of its row (by neighbour index), so the bits depend
/// neither on threads nor on when the list was built. r_ij and r_ji are exact negatives: so are
/// their forces.
///
///     v_i^C - v_j^C = v_ij - (thetadot_i d_i + thetadot_j d_j)/(d_i + d_j) z^ x r_ij   P2 Eq. (6)
///     torque on i   = -d_i/(d_i + d_j) r_ij x f_dis                                   P2 Eq. (7)
template <ContactLaw Law, class Repulsion, class Space>
struct ContactForces {
  static constexpr bool rotates = Law::rotates;

  Kokkos::View<Vec2<Real> const*, Space> position;      ///< [N], [d_s]
  Kokkos::View<Motion<rotates> const*, Space> motion;   ///< [N]
  Kokkos::View<Species const*, Space> species;          ///< [N]
  NeighborRows<Space> neighbors;
  SpeciesTable table;
  ShearedBox box;  ///< at the time of position and motion
  Law law;
  Repulsion repulsion;

  template <class Observer>
  KOKKOS_FUNCTION Action<rotates> operator()(std::uint32_t i, Observer&& observe) const {
    Action<rotates> total;
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

      Real const distance = math::sqrt(distance2);
      Contact<Real> contact;
      contact.normal = (1 / distance) * separation;
      contact.relative_overlap = 1 - distance / contact_distance;
      contact.contact_distance = contact_distance;
      Motion<rotates> const motion_j = motion(j);
      contact.velocity = motion_i.velocity - motion_j.velocity;
      contact.velocity.x -= box.velocity_shift(image);
      if constexpr (rotates) {
        Real const rolling = (motion_i.spin * diameter_i + motion_j.spin * diameter_j) /
                             (diameter_i + diameter_j);
        contact.velocity = contact.velocity - rolling * perpendicular(separation);
      }

      PairForce const pair{separation, repulsion.magnitude(contact) * contact.normal,
                           law.dissipative_force(contact), contact.relative_overlap};
      total.force += pair.elastic + pair.dissipative;
      if constexpr (rotates) {
        total.torque -=
            diameter_i / (diameter_i + diameter_j) * cross(separation, pair.dissipative);
      }
      observe(pair);
    }
    return total;
  }
};

}  // namespace bagnold
