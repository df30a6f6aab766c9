// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/species.hpp"
#include "kernels/physics/schemes/scheme.hpp"
#include "kernels/physics/schemes/second_look.hpp"
#include "kernels/cpu/contacts/lane_watch.hpp"
#include "kernels/cpu/islands/binary_pair.hpp"
#include "kernels/cpu/islands/sample_times.hpp"
#include "kernels/physics/sums/sums.hpp"
#include "kernels/cpu/simd/pack.hpp"
#include "kernels/cpu/simd/records.hpp"

namespace bagnold {

/// Islands of two disks, eight at a time, one a lane, each at its own time: a pair flies to just
/// before its contact in one go, is stepped while it touches, and flies on. So a collision costs the
/// same whatever the time between collisions.
template <ContactLaw Law, class Repulsion, Scheme Stepped>
struct BinaryCollisions {
  static constexpr bool rotates = Law::rotates;
  static constexpr bool two_stage = Stepped == Scheme::two_stage_leapfrog;
  static constexpr int width = simd::width;
  using Pack = simd::Pack;

  using Disk = BinaryDisk;

  Law law;
  Repulsion repulsion;
  SpeciesTable table;
  Real time_step;
  Real strain_rate;
  SecondLook const* second_look = nullptr;  ///< of the two-stage leapfrog

  /// Brings pairs (a[k], b[k]), k < count <= 8, through `steps` steps. What they add to the sampled
  /// sums, beyond what their straight flights would, is added to sums[k * times.bins() + bin]. watch
  /// sees every step near a contact.
  template <class Watch>
  BinaryOutcome run(Disk* a, Disk* b, int count, std::int64_t steps, SampleTimes const& times,
              Sums<true>* sums, Watch&& watch) const {
    Lanes p(*this, a, count), q(*this, b, count);
    Touch const touch(*this, a, b, count);
    BinaryOutcome outcome;
    Pack const end = static_cast<Real>(steps);
    Pack step = first_step(p, q, touch, end);
    p.fly(time_step * step);
    q.fly(time_step * step);
    std::size_t sample[width];
    Pack due;
    for (int k = 0; k < width; ++k) {
      sample[k] = times.from(static_cast<std::int64_t>(step.v[k]));
      due.v[k] = due_step(times, sample[k]);
    }
    Pack overlap = 0.0;
    unsigned busy = (1u << count) - 1u;
    while (true) {
      auto const active = simd::Mask::of(busy) & (step < end);
      if (!active.any()) break;
      Pack const dt = zero_unless(active, time_step);
      auto f = feel(p, q, touch);
      if constexpr (two_stage) look_again(f, p, q, dt, touch);
      Vec2<Pack> const velocity{p.vx - q.vx, p.vy - q.vy};
      watch.look(active, f.touching, step, f.force.separation, velocity, {p.spin, q.spin});
      auto const sampled = active & (due < step + 0.5);
      if (sampled.any())
        for (auto lanes = sampled.lanes(); lanes != 0; lanes &= lanes - 1) {
          int const k = __builtin_ctz(lanes);
          add_sample(sums[static_cast<std::size_t>(k) * times.bins() + times.bin(sample[k])], f, p,
                     q, touch, k, step.v[k]);
          watch.sample(k, times.bin(sample[k]), times.step(sample[k]), f.force.separation, velocity,
                       {p.spin, q.spin});
          due.v[k] = due_step(times, ++sample[k]);
        }
      auto const g = take_step(p, q, f, dt, touch);
      step += zero_unless(active, 1.0);
      overlap = max(overlap, zero_unless(active & g.touching, g.force.relative_overlap));
      Pack const time = time_step * step;
      p.watch(time, time_step);
      q.watch(time, time_step);
      auto const approach = approaching(p, q);
      busy &= f.touching.lanes() | g.touching.lanes() | approach.lanes();
      outcome.touching += __builtin_popcount((active & g.touching).lanes());
      outcome.steps += __builtin_popcount(active.lanes());
    }
    for (int k = 0; k < count; ++k)
      times.rest(sample[k], [&](std::size_t bin, SampleTimes::Powers const& powers) {
        auto& to = sums[static_cast<std::size_t>(k) * times.bins() + bin];
        p.add_flight(to, k, time_step * step.v[k], powers, strain_rate);
        q.add_flight(to, k, time_step * step.v[k], powers, strain_rate);
      });
    Pack const left = time_step * (end - step);
    p.fly(left);
    q.fly(left);
    p.watch(time_step * end, time_step);
    q.watch(time_step * end, time_step);
    p.store(a, count);
    q.store(b, count);
    outcome.bad = !(simd::largest(overlap) <= largest_relative_overlap) ||
                  !(simd::sum(zero_unless(simd::Mask::of((1u << count) - 1u),
                                          0.0 * (p.x + q.x + p.vx + q.vx))) == 0);
    return outcome;
  }

 private:
  struct Touch {
    Pack reach2, inverse_distance, diameter_a, diameter_b;
    Pack share_normal, share_tangential;  ///< of a lone pair, in the second look

    Touch(BinaryCollisions const& c, Disk const* a, Disk const* b, int count) {
      Pack distance;
      for (int k = 0; k < width; ++k) {
        int const j = k < count ? k : 0;
        diameter_a.v[k] = a[j].species ? big_diameter : small_diameter;
        diameter_b.v[k] = b[j].species ? big_diameter : small_diameter;
        int const both = pair_class(a[j].species, b[j].species);
        distance.v[k] = class_distance(both);
        if constexpr (two_stage) {
          share_normal.v[k] = c.second_look->normal[both][1];
          share_tangential.v[k] = c.second_look->tangential[both][1];
        }
      }
      reach2 = distance * distance;
      inverse_distance = Pack(1.0) / distance;
    }
  };

  struct Felt {
    simd::Mask touching;
    Pack x, y, turn;
    PairForce<Pack> force;
  };

  /// One disk of each pair.
  struct Lanes {
    Pack x, y, vx, vy, spin;
    Pack x0, y0, vx0, vy0, spin0;       ///< at the start of the window
    Pack inverse_mass, turn_to_spin;    ///< 1/m, d/I
    Pack stray2 = 0.0;

    Lanes(BinaryCollisions const& c, Disk const* disks, int count) {
      for (int k = 0; k < width; ++k) {
        Disk const& d = disks[k < count ? k : 0];
        x.v[k] = d.record.x;
        y.v[k] = d.record.y;
        vx.v[k] = d.record.vx;
        vy.v[k] = d.record.vy;
        spin.v[k] = d.spin;
        inverse_mass.v[k] = c.table.inverse_mass[d.species];
        turn_to_spin.v[k] = c.table.diameter[d.species] * c.table.inverse_inertia[d.species];
      }
      x0 = x, y0 = y, vx0 = vx, vy0 = vy, spin0 = spin;
    }

    void fly(Pack time) {
      x = fma(time, vx, x);
      y = fma(time, vy, y);
    }

    Lanes predicted(Felt const& f, Pack dt, Real sign) const {
      Lanes t = *this;
      t.fly(dt);
      Pack const k = sign * dt * inverse_mass;
      t.vx = fma(k, f.x, vx);
      t.vy = fma(k, f.y, vy);
      if constexpr (rotates) t.spin = fma(dt * turn_to_spin, f.turn, spin);
      return t;
    }

    void correct(Lanes const& t, Felt const& f, Pack dt, Real sign) {
      Pack const k = 0.5 * sign * dt * inverse_mass;
      Pack const wx = fma(k, f.x, 0.5 * (vx + t.vx)), wy = fma(k, f.y, 0.5 * (vy + t.vy));
      x = fma(0.5 * dt, vx + wx, x);
      y = fma(0.5 * dt, vy + wy, y);
      vx = wx;
      vy = wy;
      if constexpr (rotates)
        spin = fma(0.5 * dt * turn_to_spin, f.turn, 0.5 * (spin + t.spin));
    }

    void leap(Felt const& f, Pack dt, Real sign) {
      Pack const k = sign * dt * inverse_mass;
      vx = fma(k, f.x, vx);
      vy = fma(k, f.y, vy);
      fly(dt);
      if constexpr (rotates) spin = fma(dt * turn_to_spin, f.turn, spin);
    }

    void watch(Pack time, Real time_step) {
      Pack const dx = x - fma(time, vx0, x0), dy = y - fma(time, vy0, y0);
      Pack const ex = fma(time_step, vx - vx0, dx), ey = fma(time_step, vy - vy0, dy);
      stray2 = max(stray2, max(fma(dx, dx, dy * dy), fma(ex, ex, ey * ey)));
    }

    void store(Disk* disks, int count) const {
      for (int k = 0; k < count; ++k) {
        disks[k].record = {x.v[k], y.v[k], vx.v[k], vy.v[k]};
        disks[k].spin = spin.v[k];
        disks[k].stray2 = stray2.v[k];
      }
    }

    /// Kinetic sums at the times of `powers` of a flight that is at (y, v) at `time`, less those of the
    /// straight flight from the start.
    void add_flight(Sums<true>& sums, int k, Real time, SampleTimes::Powers const& powers,
                    Real strain_rate) const {
      using C = SumColumns;
      auto* const to = sums.value;
      auto const add = [&](Real sign, Real at_start, Real u, Real v, Real s) {
        Real const a = u - strain_rate * at_start, b = -strain_rate * v, m = sign / inverse_mass.v[k];
        Real const xx = a * a * powers.n + 2 * a * b * powers.t1 + b * b * powers.t2;
        to[C::kinetic_xx] += m * xx;
        to[C::kinetic_xy] += m * v * (a * powers.n + b * powers.t1);
        to[C::kinetic_yy] += m * v * v * powers.n;
        to[C::velocity_x2] += sign * xx;
        to[C::velocity_y2] += sign * v * v * powers.n;
        if constexpr (rotates) {
          to[C::spin] += sign * s * powers.n;
          to[C::spin2] += sign * s * s * powers.n;
        }
      };
      add(1, y.v[k] - time * vy.v[k], vx.v[k], vy.v[k], spin.v[k]);
      add(-1, y0.v[k], vx0.v[k], vy0.v[k], spin0.v[k]);
    }
  };

  static Real due_step(SampleTimes const& times, std::size_t sample) {
    return sample < times.size() ? static_cast<Real>(times.step(sample)) : 1e300;
  }

  static simd::Mask approaching(Lanes const& p, Lanes const& q) {
    return fma(p.x - q.x, p.vx - q.vx, (p.y - q.y) * (p.vy - q.vy)) < Pack(0.0);
  }

  /// The step before the one in which straight flights first touch; the end if they do not.
  Pack first_step(Lanes const& p, Lanes const& q, Touch const& touch, Pack end) const {
    Pack const x = p.x - q.x, y = p.y - q.y, vx = p.vx - q.vx, vy = p.vy - q.vy;
    Pack const b = fma(x, vx, y * vy), v2 = fma(vx, vx, vy * vy);
    Pack const c = fma(x, x, fma(y, y, -touch.reach2));
    auto const inside = c < Pack(0.0);
    Pack const discriminant = fma(b, b, -(v2 * c));
    auto const meets = inside | ((b < Pack(0.0)) & (Pack(0.0) < discriminant));
    Pack const time = (-b - sqrt(positive_part(discriminant))) / v2;
    Pack const step = select(inside, 0.0, positive_part(floor(time / time_step) - 1.0));
    return select(meets & (step < end), step, end);
  }

  Felt feel(Lanes const& p, Lanes const& q, Touch const& touch) const {
    Felt felt;
    Vec2<Pack> const separation{p.x - q.x, p.y - q.y};
    Pack const distance2 = fma(separation.x, separation.x, separation.y * separation.y);
    Pack spins = 0.0;
    if constexpr (rotates) spins = fma(touch.diameter_a, p.spin, touch.diameter_b * q.spin);
    felt.touching = distance2 < touch.reach2;
    felt.force = pair_force<Law, Repulsion, Pack>(law, repulsion, separation, distance2,
                                                  {p.vx - q.vx, p.vy - q.vy},
                                                  touch.inverse_distance, spins);
    felt.x = zero_unless(felt.touching, felt.force.elastic.x + felt.force.dissipative.x);
    felt.y = zero_unless(felt.touching, felt.force.elastic.y + felt.force.dissipative.y);
    if constexpr (rotates)
      felt.turn = zero_unless(felt.touching, felt.force.turn(touch.inverse_distance));
    return felt;
  }

  /// A step of the active lanes. Returns what was felt on the way.
  Felt take_step(Lanes& p, Lanes& q, Felt const& f, Pack dt, Touch const& touch) const {
    if constexpr (two_stage) {
      p.leap(f, dt, 1.0);
      q.leap(f, dt, -1.0);
      return f;
    } else {
      Lanes const p1 = p.predicted(f, dt, 1.0), q1 = q.predicted(f, dt, -1.0);
      auto const g = feel(p1, q1, touch);
      p.correct(p1, g, dt, 1.0);
      q.correct(q1, g, dt, -1.0);
      return g;
    }
  }

  /// Adds the damping of what f changes in a step.
  void look_again(Felt& f, Lanes const& p, Lanes const& q, Pack dt, Touch const& touch) const {
    auto const& separation = f.force.separation;
    Pack const inverse =
        inverse_sqrt(fma(separation.x, separation.x, separation.y * separation.y));
    Contact<Pack> contact;
    contact.normal = inverse * separation;
    contact.relative_overlap = f.force.relative_overlap;
    contact.inverse_distance = touch.inverse_distance;
    Pack const per_force = dt * (p.inverse_mass + q.inverse_mass);
    Pack const per_turn =
        dt * fma(touch.diameter_a, p.turn_to_spin, touch.diameter_b * q.turn_to_spin);
    Vec2<Pack> change{per_force * f.x, per_force * f.y};
    if constexpr (rotates) {
      change = change - (0.5 * touch.inverse_distance * per_turn * f.turn) * perpendicular(separation);
    }
    contact.velocity =
        looked_at<Law>(change, contact.normal, touch.share_normal, touch.share_tangential);
    auto const more = law.dissipative_force(contact);
    PairForce<Pack> const second{separation, {}, more, {}, {}};
    f.force.dissipative = f.force.dissipative + more;
    f.force.velocity =
        f.force.velocity + Pack(0.5) * (change + own_change<Law>(second, touch.inverse_distance,
                                                                 per_force, per_turn));
    f.x += zero_unless(f.touching, more.x);
    f.y += zero_unless(f.touching, more.y);
    if constexpr (rotates)
      f.turn = zero_unless(f.touching, f.force.turn(touch.inverse_distance));
  }

  /// One evaluated configuration of one pair, less that of its straight flights.
  void add_sample(Sums<true>& sums, Felt const& f, Lanes const& p, Lanes const& q,
                  Touch const& touch, int k, Real step) const {
    using C = SumColumns;
    auto* const to = sums.value;
    if (f.touching.lanes() >> k & 1) {
      auto const& [r, elastic, dissipative, overlap, velocity] = f.force;
      to[C::elastic_xx] += elastic.x.v[k] * r.x.v[k];
      to[C::elastic_xy] += elastic.x.v[k] * r.y.v[k];
      to[C::elastic_yy] += elastic.y.v[k] * r.y.v[k];
      to[C::dissipative_xx] += dissipative.x.v[k] * r.x.v[k];
      to[C::dissipative_xy] += dissipative.x.v[k] * r.y.v[k];
      to[C::dissipative_yx] += dissipative.y.v[k] * r.x.v[k];
      to[C::dissipative_yy] += dissipative.y.v[k] * r.y.v[k];
      to[C::dissipation] -= dissipative.x.v[k] * velocity.x.v[k] + dissipative.y.v[k] * velocity.y.v[k];
      to[C::contacts] += 2;
      if constexpr (rotates) {
        Real const turn = f.turn.v[k], half = two_stage ? time_step / 2 : 0;
        to[C::torque_power] +=
            touch.diameter_a.v[k] * turn * (p.spin.v[k] + half * p.turn_to_spin.v[k] * turn) +
            touch.diameter_b.v[k] * turn * (q.spin.v[k] + half * q.turn_to_spin.v[k] * turn);
      }
    }
    Real const time = time_step * step;
    SampleTimes::Powers const now{1, time, time * time};
    p.add_flight(sums, k, time, now, strain_rate);
    q.add_flight(sums, k, time, now, strain_rate);
  }
};

}  // namespace bagnold
