// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/world.hpp"
#include "kernels/physics/laws/pair_force.hpp"

namespace bagnold::accuracy {

/// The contact as a law sees it, for disks moving as `motion` says: velocity is v_i - v_j with the
/// shear of the image, at the point of contact (P2 Eq. 6) if the law rotates.
template <class World>
Contact<typename World::Pair> contact_of(World const& world, Touch<typename World::Pair> const& t,
                                         typename World::Motions const& motion) {
  using Pair = typename World::Pair;
  auto const &a = motion[t.i], &b = motion[t.j];
  Vec2<Pair> const velocity{static_cast<Pair>(a.velocity.x - b.velocity.x) - t.velocity_shift,
                            static_cast<Pair>(a.velocity.y - b.velocity.y)};
  Pair spins = 0;
  if constexpr (World::rotates)
    spins = static_cast<Pair>(a.spin * world.table.diameter[world.species[t.i]] +
                              b.spin * world.table.diameter[world.species[t.j]]);
  return {
      t.normal,
      velocity_at_contact<typename World::Law>(velocity, t.separation, t.inverse_distance, spins),
      t.relative_overlap, t.inverse_distance};
}

/// On i from j, P1 and P2 Eq. (2).
template <class World>
Vec2<typename World::Pair> elastic_force(World const& world, Touch<typename World::Pair> const& t) {
  Contact<typename World::Pair> const still{t.normal, {}, t.relative_overlap, t.inverse_distance};
  return world.repulsion.magnitude(still) * t.normal;
}

/// V_ij, P1 and P2 Eq. (1).
template <class World>
double elastic_energy(World const& world, Touch<typename World::Pair> const& t) {
  double const alpha = decltype(world.repulsion)::force_exponent;
  return std::pow(static_cast<double>(t.relative_overlap), alpha) / alpha;
}

/// An impulse on i, at the point of contact: the opposite one on j, and the torque_per_diameter
/// that P2 Eq. (7) gives both where the law rotates and the force is dissipative.
template <class World>
void exert(World const& world, Touch<typename World::Pair> const& t,
           Vec2<typename World::Pair> const& impulse, typename World::Motions& motion) {
  using Kept = typename World::Kept;
  auto const si = world.species[t.i], sj = world.species[t.j];
  Vec2<Kept> const j{static_cast<Kept>(impulse.x), static_cast<Kept>(impulse.y)};
  motion[t.i].velocity += static_cast<Kept>(world.table.inverse_mass[si]) * j;
  motion[t.j].velocity += static_cast<Kept>(-world.table.inverse_mass[sj]) * j;
  if constexpr (World::rotates) {
    auto const torque_per_diameter = static_cast<Kept>(-0.5) *
                                     static_cast<Kept>(t.inverse_distance) *
                                     static_cast<Kept>(cross(t.separation, impulse));
    auto const to_spin = [&](Species s) {
      return static_cast<Kept>(world.table.diameter[s] * world.table.inverse_inertia[s]);
    };
    motion[t.i].spin += to_spin(si) * torque_per_diameter;
    motion[t.j].spin += to_spin(sj) * torque_per_diameter;
  }
}

/// Elastic impulses of all contacts, forces times `time`. A central one does not
/// torque_per_diameter, and the rounding of r x n must not either.
template <class World>
void kick_elastic(World const& world, typename World::Touches const& touches, double time,
                  typename World::Motions& motion) {
  using Kept = typename World::Kept;
  using Pair = typename World::Pair;
  for (auto const& t : touches) {
    Vec2<Pair> const f = static_cast<Pair>(time) * elastic_force(world, t);
    Vec2<Kept> const j{static_cast<Kept>(f.x), static_cast<Kept>(f.y)};
    motion[t.i].velocity += static_cast<Kept>(world.table.inverse_mass[world.species[t.i]]) * j;
    motion[t.j].velocity += static_cast<Kept>(-world.table.inverse_mass[world.species[t.j]]) * j;
  }
}

/// Dissipative impulses of all contacts, of velocities in `felt` on those in `motion`.
template <class World>
void kick_dissipative(World const& world, typename World::Touches const& touches, double time,
                      typename World::Motions const& felt, typename World::Motions& motion) {
  using Pair = typename World::Pair;
  for (auto const& t : touches)
    exert(world, t,
          static_cast<Pair>(time) * world.law.dissipative_force(contact_of(world, t, felt)),
          motion);
}

}  // namespace bagnold::accuracy
