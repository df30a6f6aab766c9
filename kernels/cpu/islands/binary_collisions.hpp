// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/contacts/lane_detector.hpp"
#include "kernels/cpu/islands/binary_pair.hpp"
#include "kernels/cpu/islands/flight_sums.hpp"
#include "kernels/cpu/islands/sample_times.hpp"
#include "kernels/cpu/simd/pack.hpp"
#include "kernels/cpu/simd/records.hpp"
#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "kernels/physics/schemes/second_stage.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Steps islands of two disks, a pack at a time, one island a lane, each at its own time. A pair
/// flies to just before its contact at once, is stepped while it touches, and flies on. The cost of
/// a collision is therefore independent of the time between collisions.
template <ContactLaw Law, class Repulsion, class Scheme>
struct BinaryCollisions {
  static constexpr bool rotates = Law::rotates;
  static constexpr bool two_stage = TwoStageScheme<Scheme>;
  static_assert(two_stage || PredictCorrectScheme<Scheme>, "lone pairs have no step of this form");
  static constexpr int width = simd::width;
  using Pack = simd::Pack;

  using Disk = BinaryDisk;

  Law law;
  Repulsion repulsion;
  SpeciesTable table;
  Real time_step;
  Real strain_rate;                           ///< where the lookahead begins
  SecondStage const* second_stage = nullptr;  ///< of a scheme that has one

  /// Steps pairs (a[k], b[k]), k < count <= width, through `steps` steps. Adds to sums[k *
  /// times.bins() + bin] the sampled sums of pair k less those of its straight flights. detector
  /// sees every step near a contact.
  template <class Detector>
  BinaryOutcome run(Disk* a, Disk* b, int count, std::int64_t steps, FlightTimes const& flights,
                    SampleTimes const& times, BlockSums* sums, Detector&& detector) const {
    Lanes p(*this, a, count), q(*this, b, count);
    PairConstants const pair(*this, a, b, count);
    PairDeviation deviation(relative(p, q));
    BinaryOutcome outcome;
    Pack const end = static_cast<Real>(steps);
    bool const at_one_rate = flights.at_one_rate();
    Pack step = first_step(p, q, pair, end, flights);
    Pack time = at_one_rate ? time_step * step : times_of(flights, step);
    p.fly(time);
    q.fly(time);
    Pack scale = 1.0;  // of velocities and spins, by which they have grown with the rate
    if (!at_one_rate) grow(p, q, scale, scales_of(flights, step));
    std::size_t sample[width];
    Pack due;
    for (int k = 0; k < width; ++k) {
      sample[k] = times.from(static_cast<std::int64_t>(step.v[k]));
      due.v[k] = due_after(times, sample[k]);
    }
    Relative pq = relative(p, q);
    Pack overlap = 0.0, touching = 0.0;  // touching: steps
    Pack const first = step;
    auto busy = simd::first_lanes(static_cast<std::uint32_t>(count));
    while (true) {
      auto const active = busy & (step < end);
      if (!active.any()) break;
      Pack const dt = simd::zero_unless(active, time_step);
      auto f = evaluate(pq, p.spin, q.spin, pair);
      if constexpr (two_stage) add_second_stage(f, p, q, dt, pair);
      detector.detect(active, f.touching, step, pq.separation, pq.velocity, {p.spin, q.spin});
      auto const sampled = active & (due < step);
      if (sampled.any())
        for (auto lanes = sampled.lanes(); lanes != 0; lanes &= lanes - 1) {
          int const k = __builtin_ctz(lanes);
          add_sample(sums[static_cast<std::size_t>(k) * times.bins() + times.bin(sample[k])], f, p,
                     q, pair, k, time.v[k], scale.v[k]);
          detector.sample(k, times.bin(sample[k]), times.step(sample[k]), pq.separation,
                          pq.velocity, {p.spin, q.spin});
          due.v[k] = due_after(times, ++sample[k]);
        }
      auto const g = take_step(p, q, f, dt, pair);
      step += simd::zero_unless(active, 1.0);
      overlap = max(overlap, simd::zero_unless(active & g.touching, g.force.relative_overlap));
      touching += simd::zero_unless(active & g.touching, 1.0);
      if (at_one_rate) {
        time = time_step * step;
      } else {
        time = times_of(flights, step);
        grow(p, q, scale, scales_of(flights, step));
      }
      pq = relative(p, q);
      deviation.keep(pq, time, scale, time_step);
      busy = busy & (f.touching | g.touching | approaching(pq));
    }
    outcome.touching = static_cast<std::int64_t>(simd::sum(touching));
    outcome.steps = static_cast<std::int64_t>(simd::sum(step - first));
    if (!at_one_rate) grow(p, q, scale, 1.0);
    for (int k = 0; k < count; ++k)
      times.rest(sample[k], [&](std::size_t bin, SampleTimes::Powers const& powers) {
        auto& to = sums[static_cast<std::size_t>(k) * times.bins() + bin];
        p.add_flight(to, k, time.v[k], powers, strain_rate);
        q.add_flight(to, k, time.v[k], powers, strain_rate);
      });
    Pack const last = flights.time(steps);
    Pack const left = at_one_rate ? time_step * (end - step) : last - time;
    p.fly(left);
    q.fly(left);
    if (!at_one_rate) grow(p, q, scale, flights.scale(steps));
    deviation.keep(relative(p, q), last, scale, time_step);
    p.store(a, count, deviation.of_disk(p.inverse_mass, q.inverse_mass));
    q.store(b, count, deviation.of_disk(q.inverse_mass, p.inverse_mass));
    outcome.bad = !(simd::largest(overlap) <= largest_relative_overlap) ||
                  !(simd::sum(simd::zero_unless(simd::Mask::of((1u << count) - 1u),
                                                0.0 * (p.x + q.x + p.vx + q.vx))) == 0);
    return outcome;
  }

 private:
  struct PairConstants {
    Pack reach2, inverse_distance, diameter_a, diameter_b;
    Pack share_normal, share_tangential;  ///< of a lone pair, in the second stage

    PairConstants(BinaryCollisions const& c, Disk const* a, Disk const* b, int count) {
      Pack distance;
      for (int k = 0; k < width; ++k) {
        int const j = k < count ? k : 0;
        diameter_a.v[k] = a[j].species ? big_diameter : small_diameter;
        diameter_b.v[k] = b[j].species ? big_diameter : small_diameter;
        int const both = pair_class(a[j].species, b[j].species);
        distance.v[k] = class_distance(both);
        if constexpr (two_stage) {
          share_normal.v[k] = c.second_stage->normal[both][1];
          share_tangential.v[k] = c.second_stage->tangential[both][1];
        }
      }
      reach2 = distance * distance;
      inverse_distance = Pack(1.0) / distance;
    }
  };

  /// Forces of a pair, zero where it does not touch.
  struct PairContact {
    simd::Mask touching;
    Vec2<Pack> total;          ///< elastic and dissipative, on a from b
    Pack torque_per_diameter;  ///< torque over diameter
    PairForce<Pack> force;
  };

  /// Motion of the first disk of each pair relative to the second.
  struct Relative {
    Vec2<Pack> separation, velocity;
  };

  /// Largest deviation of pairs from their straight flights. The centre of mass flies straight, so
  /// the deviation of a disk is its share of that of the separation.
  class PairDeviation {
   public:
    explicit PairDeviation(Relative const& start) : start_(start) {}

    /// scale: growth of velocities since the start, with the strain rate.
    void keep(Relative const& now, Pack time, Pack scale, Real time_step) {
      auto const& [r, v] = now;
      auto const& [r0, v0] = start_;
      Pack const dx = r.x - fma(time, v0.x, r0.x), dy = r.y - fma(time, v0.y, r0.y);
      Pack const ex = fma(time_step, fnma(scale, v0.x, v.x), dx),
                 ey = fma(time_step, fnma(scale, v0.y, v.y), dy);
      largest2_ = max(largest2_, max(fma(dx, dx, dy * dy), fma(ex, ex, ey * ey)));
    }

    /// Largest squared deviation of the disk with this inverse mass, [d_s^2].
    Pack of_disk(Pack inverse_mass, Pack of_other) const {
      Pack const share = inverse_mass / (inverse_mass + of_other);
      return share * share * largest2_;
    }

   private:
    Relative start_;
    Pack largest2_ = 0.0;
  };

  /// Motion of one disk of each pair, which a step changes.
  struct Motion {
    Pack x, y, vx, vy, spin;

    Vec2<Pack> position() const { return {x, y}; }
    Vec2<Pack> velocity() const { return {vx, vy}; }
    void set(Vec2<Pack> const& r, Vec2<Pack> const& v) { x = r.x, y = r.y, vx = v.x, vy = v.y; }
  };

  /// Motion of one disk of each pair with its constants and its motion at the start of the
  /// lookahead.
  struct Lanes : Motion {
    using Motion::position, Motion::velocity, Motion::set;
    using Motion::x, Motion::y, Motion::vx, Motion::vy, Motion::spin;
    Pack x0, y0, vx0, vy0, spin0;       ///< at the start of the lookahead
    Pack inverse_mass, torque_to_spin;  ///< 1/m, d/I

    Lanes(BinaryCollisions const& c, Disk const* disks, int count) {
      for (int k = 0; k < width; ++k) {
        Disk const& d = disks[k < count ? k : 0];
        x.v[k] = d.record.x;
        y.v[k] = d.record.y;
        vx.v[k] = d.record.vx;
        vy.v[k] = d.record.vy;
        spin.v[k] = d.spin;
        inverse_mass.v[k] = c.table.inverse_mass[d.species];
        torque_to_spin.v[k] = c.table.diameter[d.species] * c.table.inverse_inertia[d.species];
      }
      x0 = x, y0 = y, vx0 = vx, vy0 = vy, spin0 = spin;
    }

    void fly(Pack time) { set(flown(position(), velocity(), time), velocity()); }

    void grow(Pack factor) {
      set(position(), factor * velocity());
      spin = factor * spin;
    }

    /// sign: 1 for disk a, -1 for b, on which the opposite force acts.
    Motion predicted(PairContact const& f, Pack dt, Real sign) const {
      Motion t;
      t.spin = spin;
      t.set(Scheme::trial_position(position(), velocity(), dt),
            Scheme::trial_velocity(velocity(), f.total, sign * dt * inverse_mass));
      if constexpr (rotates)
        t.spin = Scheme::trial_velocity(spin, f.torque_per_diameter, dt * torque_to_spin);
      return t;
    }

    void correct(Motion const& t, PairContact const& f, Pack dt, Real sign) {
      auto const after =
          Scheme::velocity(velocity(), t.velocity(), f.total, 0.5 * sign * dt * inverse_mass);
      set(Scheme::position(position(), velocity(), after, 0.5 * dt), after);
      if constexpr (rotates)
        spin = Scheme::velocity(spin, t.spin, f.torque_per_diameter, 0.5 * dt * torque_to_spin);
    }

    void leap(PairContact const& f, Pack dt, Real sign) {
      auto const after = Scheme::velocity_of_pair(velocity(), f.total, sign * dt * inverse_mass);
      set(Scheme::position(position(), after, dt), after);
      if constexpr (rotates)
        spin = Scheme::velocity_of_pair(spin, f.torque_per_diameter, dt * torque_to_spin);
    }

    void store(Disk* disks, int count, Pack deviation2) const {
      for (int k = 0; k < count; ++k) {
        disks[k].record = {x.v[k], y.v[k], vx.v[k], vy.v[k]};
        disks[k].spin = spin.v[k];
        disks[k].flight_deviation2 = deviation2.v[k];
      }
    }

    /// Adds the sums of lane k at the times of `powers` on a flight that is at (y, v) at `time`,
    /// less those of its straight flight from the start. v is scaled to the rate of the start.
    void add_flight(BlockSums& sums, int k, Real time, SampleTimes::Powers const& powers,
                    Real strain_rate) const {
      SumsAtTimes const ended{sums, powers, 1}, straight{sums, powers, -1};
      Real const start = y.v[k] - time * vy.v[k];
      add(ended, k, flight_x(vx.v[k], start, vy.v[k], strain_rate), vy.v[k], spin.v[k]);
      add(straight, k, flight_x(vx0.v[k], y0.v[k], vy0.v[k], strain_rate), vy0.v[k], spin0.v[k]);
    }

    /// Adds the sums of lane k at `time` alone, less those of its straight flight. The disk is at
    /// (y, v), where v and the rate have grown to `scale`.
    void add_now(BlockSums& sums, int k, Real time, Real scale, Real strain_rate) const {
      SampleTimes::Powers const once{1, 0, 0, 1, 1};
      SumsAtTimes const now{sums, once, 1}, straight{sums, once, -1};
      Real const flown = y0.v[k] + time * vy0.v[k];
      add(now, k, peculiar_x(vx.v[k], y.v[k], strain_rate), vy.v[k], spin.v[k]);
      add(straight, k, peculiar_x(scale * vx0.v[k], flown, strain_rate), scale * vy0.v[k],
          scale * spin0.v[k]);
    }

    /// ux: v_x - gammadot y, as a number or as a polynomial in time.
    template <class X>
    BAGNOLD_INLINE void add(SumsAtTimes const& to, int k, X const& ux, Real v, Real turning) const {
      add_motion(to, 1 / inverse_mass.v[k], ux, v);
      if constexpr (rotates) add_spin(to, turning);
    }
  };

  /// Step of a sample less a half, against rounding; 1e300 after the last sample. [steps]
  static Real due_after(SampleTimes const& times, std::size_t sample) {
    return sample < times.size() ? static_cast<Real>(times.step(sample)) - 0.5 : 1e300;
  }

  static Pack times_of(FlightTimes const& flights, Pack const& step) {
    Pack time;
    for (int k = 0; k < width; ++k) time.v[k] = flights.time(static_cast<std::int64_t>(step.v[k]));
    return time;
  }
  static Pack scales_of(FlightTimes const& flights, Pack const& step) {
    Pack scale;
    for (int k = 0; k < width; ++k)
      scale.v[k] = flights.scale(static_cast<std::int64_t>(step.v[k]));
    return scale;
  }

  /// Scales velocities and spins to another strain rate.
  static void grow(Lanes& p, Lanes& q, Pack& scale, Pack const& to) {
    Pack const factor = to / scale;
    p.grow(factor);
    q.grow(factor);
    scale = to;
  }

  static Relative relative(Motion const& p, Motion const& q) {
    return {p.position() - q.position(), p.velocity() - q.velocity()};
  }

  static simd::Mask approaching(Relative const& pq) {
    return fma(pq.separation.x, pq.velocity.x, pq.separation.y * pq.velocity.y) < Pack(0.0);
  }

  /// Step before the one in which straight flights first touch; `end` if they do not.
  Pack first_step(Lanes const& p, Lanes const& q, PairConstants const& pair, Pack end,
                  FlightTimes const& flights) const {
    Pack const x = p.x - q.x, y = p.y - q.y, vx = p.vx - q.vx, vy = p.vy - q.vy;
    Pack const b = fma(x, vx, y * vy), v2 = fma(vx, vx, vy * vy);
    Pack const c = fma(x, x, fma(y, y, -pair.reach2));
    auto const inside = c < Pack(0.0);
    Pack const discriminant = fma(b, b, -(v2 * c));
    auto const meets = inside | ((b < Pack(0.0)) & (Pack(0.0) < discriminant));
    Pack const time = (-b - sqrt(positive_part(discriminant))) / v2;
    Pack const until = flights.at_one_rate() ? floor(time / time_step) : steps_of(flights, time);
    Pack const step = select(inside, 0.0, positive_part(until - 1.0));
    return select(meets & (step < end), step, end);
  }

  static Pack steps_of(FlightTimes const& flights, Pack const& time) {
    Pack steps;
    for (int k = 0; k < width; ++k) steps.v[k] = flights.steps_until(0, time.v[k]);
    return steps;
  }

  static Vec2<Pack> zero_unless(simd::Mask mask, Vec2<Pack> const& v) {
    return {simd::zero_unless(mask, v.x), simd::zero_unless(mask, v.y)};
  }

  PairContact evaluate(Relative const& pq, Pack spin_a, Pack spin_b,
                       PairConstants const& pair) const {
    PairContact f;
    auto const& separation = pq.separation;
    Pack const distance2 = fma(separation.x, separation.x, separation.y * separation.y);
    Pack spins = 0.0;
    if constexpr (rotates) spins = fma(pair.diameter_a, spin_a, pair.diameter_b * spin_b);
    f.touching = distance2 < pair.reach2;
    f.force = pair_force<Law, Repulsion, Pack>(law, repulsion, separation, distance2, pq.velocity,
                                               pair.inverse_distance, spins);
    f.total = zero_unless(f.touching, f.force.elastic + f.force.dissipative);
    if constexpr (rotates)
      f.torque_per_diameter =
          simd::zero_unless(f.touching, f.force.torque_per_diameter(pair.inverse_distance));
    return f;
  }

  /// Steps the active lanes. Returns the forces evaluated last.
  PairContact take_step(Lanes& p, Lanes& q, PairContact const& f, Pack dt,
                        PairConstants const& pair) const {
    if constexpr (two_stage) {
      p.leap(f, dt, 1.0);
      q.leap(f, dt, -1.0);
      return f;
    } else {
      Motion const p1 = p.predicted(f, dt, 1.0), q1 = q.predicted(f, dt, -1.0);
      auto const g = evaluate(relative(p1, q1), p1.spin, q1.spin, pair);
      p.correct(p1, g, dt, 1.0);
      q.correct(q1, g, dt, -1.0);
      return g;
    }
  }

  /// Adds the damping of the changes that f makes in a step.
  void add_second_stage(PairContact& f, Lanes const& p, Lanes const& q, Pack dt,
                        PairConstants const& pair) const {
    auto const& separation = f.force.separation;
    Pack const per_force = dt * (p.inverse_mass + q.inverse_mass);
    Pack const per_torque =
        dt * fma(pair.diameter_a, p.torque_to_spin, pair.diameter_b * q.torque_to_spin);
    auto const change_by = [&](Vec2<Pack> const& force, Pack const& torque_per_diameter) {
      return change_of_pair<Law>(force, torque_per_diameter, separation, pair.inverse_distance,
                                 per_force, per_torque);
    };
    auto const change = change_by(f.total, f.torque_per_diameter);
    Pack const distance2 = fma(separation.x, separation.x, separation.y * separation.y);
    auto const contact =
        second_stage_contact<Law>(separation, distance2, pair.inverse_distance, change,
                                  pair.share_normal, pair.share_tangential);
    PairForce<Pack> const second{separation, {}, law.dissipative_force(contact), {}, {}};
    Pack torque_per_diameter = 0.0;
    if constexpr (rotates) torque_per_diameter = second.torque_per_diameter(pair.inverse_distance);
    f.force.dissipative = f.force.dissipative + second.dissipative;
    f.force.velocity = f.force.velocity +
                       Pack(0.5) * (change + change_by(second.dissipative, torque_per_diameter));
    f.total += zero_unless(f.touching, second.dissipative);
    if constexpr (rotates)
      f.torque_per_diameter =
          simd::zero_unless(f.touching, f.force.torque_per_diameter(pair.inverse_distance));
  }

  /// Adds one evaluated configuration of one pair, less that of its straight flights.
  void add_sample(BlockSums& sums, PairContact const& f, Lanes const& p, Lanes const& q,
                  PairConstants const& pair, int k, Real time, Real scale) const {
    if (f.touching.lanes() >> k & 1) {
      add_pair(sums.value, lane(f.force, k), 1);
      if constexpr (rotates) {
        Real const torque_per_diameter = f.torque_per_diameter.v[k],
                   half = two_stage ? time_step / 2 : 0;
        sums.value[SumColumns::torque_power] +=
            pair.diameter_a.v[k] * torque_per_diameter *
                (p.spin.v[k] + half * p.torque_to_spin.v[k] * torque_per_diameter) +
            pair.diameter_b.v[k] * torque_per_diameter *
                (q.spin.v[k] + half * q.torque_to_spin.v[k] * torque_per_diameter);
      }
    }
    p.add_now(sums, k, time, scale, scale * strain_rate);
    q.add_now(sums, k, time, scale, scale * strain_rate);
  }

  static Vec2<Real> lane(Vec2<Pack> const& v, int k) { return {v.x.v[k], v.y.v[k]}; }

  static PairForce<Real> lane(PairForce<Pack> const& f, int k) {
    return {lane(f.separation, k), lane(f.elastic, k), lane(f.dissipative, k),
            f.relative_overlap.v[k], lane(f.velocity, k)};
  }
};

}  // namespace bagnold
