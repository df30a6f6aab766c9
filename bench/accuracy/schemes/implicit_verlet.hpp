// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

/// The self-consistent form of velocity Verlet (Pagonabarraga, Hagen and Frenkel, Europhys. Lett.
/// 42, 377 (1998)): the damping feels the velocity that it results in. Between positions r_n
///
///     v_+ = v_- + [f_el(r_n) + f_dis(r_n, (v_- + v_+)/2)] dt/m,   r_n+1 = r_n + v_+ dt,
///
/// one evaluation of the elastic force. f_dis is linear in v: the equation for u = (v_- + v_+)/2,
///
///     (1 + A dt/2) u = v_- + f_el dt/2m,   A v = -f_dis(r_n, v)/m,
///
/// is solved by conjugate gradients in the scalar product with the masses. What the pairwise
/// schemes approximate; costly, as it goes over the contacts many times.
template <class World>
struct ImplicitVerlet {
  static constexpr std::string_view name = "implicit-verlet";
  static constexpr bool staggered = true;
  using Kept = typename World::Kept;
  using Motions = typename World::Motions;

  typename World::Touches touches, still;  ///< still: as changes of motion see them
  Motions middle, residual, direction, image;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    still = touches;
    for (auto& t : still) t.velocity_shift = 0;
    middle = world.motion;
    kick_elastic(world, touches, dt / 2, middle);
    solve(world);
    if (sample) {
      sample_elastic(world, touches, *sample);
      sample_dissipative(world, touches, middle, *sample);
      sample_motion(world, world.position, world.motion, *sample);
    }
    for (std::size_t i = 0; i < world.size(); ++i) {
      auto& v = world.motion[i];
      v.velocity = Kept(2) * middle[i].velocity - v.velocity;
      v.spin = 2 * middle[i].spin - v.spin;
    }
    world.fly();
    world.finish_step();
  }

 private:
  /// x + A x dt/2 for velocities that are differences (no shear of images).
  void apply(World& world, Motions const& x, Motions& result) {
    result = x;
    kick_dissipative(world, still, -world.clock.time_step / 2, x, result);
    ++world.counts.damping_passes;
  }

  double product(World const& world, Motions const& a, Motions const& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      auto const s = world.species[i];
      sum += dot(wide(a[i].velocity), wide(b[i].velocity)) / world.table.inverse_mass[s] +
             static_cast<double>(a[i].spin) * b[i].spin / world.table.inverse_inertia[s];
    }
    return sum;
  }

  static void add(Motions& to, double factor, Motions const& x) {
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i].velocity += static_cast<Kept>(factor) * x[i].velocity;
      to[i].spin += static_cast<Kept>(factor) * x[i].spin;
    }
  }

  /// middle holds the right side, and the solution afterwards.
  void solve(World& world) {
    residual.assign(world.size(), {});
    kick_dissipative(world, touches, world.clock.time_step / 2, middle, residual);
    direction = residual;
    double square = product(world, residual, residual);
    double const enough = 1e-24 * square;
    for (int k = 0; k < 200 && square > enough; ++k) {
      apply(world, direction, image);
      double const length = square / product(world, direction, image);
      add(middle, length, direction);
      add(residual, -length, image);
      double const next = product(world, residual, residual);
      Motions turned = residual;
      add(turned, next / square, direction);
      std::swap(direction, turned);
      square = next;
    }
  }
};

}  // namespace bagnold::accuracy
