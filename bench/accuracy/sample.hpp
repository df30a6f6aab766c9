// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "bench/accuracy/pairs.hpp"
#include "kernels/device/sums/measure.hpp"

namespace bagnold::accuracy {

/// What a scheme tells of one step: the columns of SumColumns, and what the energy balance needs.
struct Sample {
  enum : int {
    kinetic_energy = SumColumns::count_rotating,  ///< 1/2 sum m dv^2 + 1/2 sum I thetadot^2
    elastic_energy,                               ///< sum V_ij
    dissipated,                                   ///< per tau_e, > 0
    count
  };
  std::array<double, count> value{};

  void add_elastic(Vec2<double> const& f, Vec2<double> const& r) {
    value[SumColumns::elastic_xx] += f.x * r.x;
    value[SumColumns::elastic_xy] += f.x * r.y;
    value[SumColumns::elastic_yy] += f.y * r.y;
    value[SumColumns::contacts] += 2;
  }
  void add_dissipative(Vec2<double> const& f, Vec2<double> const& r, double power) {
    value[SumColumns::dissipative_xx] += f.x * r.x;
    value[SumColumns::dissipative_xy] += f.x * r.y;
    value[SumColumns::dissipative_yx] += f.y * r.x;
    value[SumColumns::dissipative_yy] += f.y * r.y;
    value[dissipated] += power;
  }
};

template <class T>
Vec2<double> wide(Vec2<T> const& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// Adds the elastic force and energy of all contacts.
template <class World>
void sample_elastic(World const& world, typename World::Touches const& touches, Sample& sample) {
  for (auto const& t : touches) {
    sample.add_elastic(wide(elastic_force(world, t)), wide(t.separation));
    sample.value[Sample::elastic_energy] += elastic_energy(world, t);
  }
}

/// Adds the dissipative force of all contacts of disks that move as `felt` says.
template <class World>
void sample_dissipative(World const& world, typename World::Touches const& touches,
                        typename World::Motions const& felt, Sample& sample) {
  for (auto const& t : touches) {
    auto const contact = contact_of(world, t, felt);
    auto const f = wide(world.law.dissipative_force(contact));
    sample.add_dissipative(f, wide(t.separation), -dot(f, wide(contact.velocity)));
  }
}

/// Adds a dissipative impulse of one step, relative motion being `before` and `after` it: the
/// energy lost is that of the pair.
template <class World>
void sample_impulse(World const& world, Touch<typename World::Pair> const& t,
                    Vec2<double> const& impulse, Contact<typename World::Pair> const& before,
                    Contact<typename World::Pair> const& after, Sample& sample) {
  Vec2<double> const force = (1 / world.clock.time_step) * impulse;
  Vec2<double> const mean = 0.5 * (wide(before.velocity) + wide(after.velocity));
  sample.add_dissipative(force, wide(t.separation), -dot(force, mean));
}

/// Adds the motion of all disks, dv = v - gammadot y x^.
template <class World>
void sample_motion(World const& world, typename World::Positions const& position,
                   typename World::Motions const& motion, Sample& sample) {
  auto& to = sample.value;
  for (std::size_t i = 0; i < world.size(); ++i) {
    auto const species = world.species[i];
    double const m = 1 / world.table.inverse_mass[species];
    double const vx =
        peculiar_x<double>(motion[i].velocity.x, position[i].y, world.clock.strain_rate);
    double const vy = motion[i].velocity.y, spin = motion[i].spin;
    add_motion(to, m, vx, vy);
    to[Sample::kinetic_energy] += m * (vx * vx + vy * vy) / 2;
    if constexpr (World::rotates) {
      add_spin(to, spin);
      to[Sample::kinetic_energy] += spin * spin / world.table.inverse_inertia[species] / 2;
    }
  }
}

}  // namespace bagnold::accuracy
