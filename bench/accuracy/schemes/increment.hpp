// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/schemes/pair_relaxation.hpp"
#include "bench/accuracy/schemes/scheme.hpp"

namespace bagnold::accuracy {

enum class Share { exact, midpoint, euler };

inline Real part_lost(Share s, Real z) {
  if (s == Share::exact) return z < 1e-5 ? z / 2 : 1 + std::expm1(-z) / z;
  Real const t = s == Share::midpoint ? z / 2 : z;
  return t / (1 + t);
}

struct IncrementBy {
  Real normal[3], tangential[3], mu_n[3], mu_t[3];
  template <ContactLaw Law>
  IncrementBy(Law const& law, SpeciesTable const& table, Share share, Real time, Real parts = 1,
              Real least = 0) {
    for (int big = 0; big < 3; ++big) {
      int const a = big == 2 ? 1 : 0, b = big == 0 ? 0 : 1;
      Real const inverse = (table.inverse_mass[a] + table.inverse_mass[b]) * parts;
      Real rolling = 0;
      if constexpr (Law::rotates)
        rolling = (table.diameter[a] * table.diameter[a] * table.inverse_inertia[a] +
                   table.diameter[b] * table.diameter[b] * table.inverse_inertia[b]) /
                  4 * parts;
      mu_n[big] = 1 / inverse;
      mu_t[big] = 1 / (inverse + rolling);
      Real const zn = normal_damping(law) * time / mu_n[big], zt = tangential_damping(law) * time / mu_t[big];
      normal[big] = std::max(part_lost(share, zn), least * zn);
      tangential[big] = std::max(part_lost(share, zt), least * zt);
    }
  }
};

template <class World>
struct Increment {
  static constexpr std::string_view name = "increment";
  using Kept = typename World::Kept;
  using Pair = typename World::Pair;
  using Motions = typename World::Motions;
  using Touches = typename World::Touches;

  Share share = Share::exact;
  int sweeps = 1;
  bool alternate = false, jacobi = false;
  int jacobi_parts = 0;
  Real least = 0;  ///< alpha at least
  int pack = 1;  // contacts worked on at once from the same increments
  Motions felt;

  Touches touches;
  Motions change, start;
  std::vector<int> parts;
  std::vector<Vec2<Pair>> total, later;

  void step(World& world, Sample* sample) {
    double const dt = world.clock.time_step;
    world.find_touches(world.position, world.step, touches);
    if (sample) {
      sample_elastic(world, touches, *sample);
      sample_motion(world, world.position, world.motion, 1, *sample);
    }
    change.assign(world.size(), {});
    kick_elastic(world, touches, dt, change);
    total.resize(touches.size());
    later.assign(touches.size(), {});
    for (std::size_t k = 0; k < touches.size(); ++k) {
      auto const f = world.law.dissipative_force(contact_of(world, touches[k], world.motion));
      total[k] = static_cast<Pair>(dt) * f;
      exert(world, touches[k], total[k], change);
    }
    std::size_t const across = jacobi ? touches.size() : world.across();
    if (sweeps > 0 && across > 0) relax_together(world, dt, across);
    IncrementBy const by(world.law, world.table, share, dt);
    for (int s = 0; s < sweeps; ++s) {
      bool const backwards = (alternate && world.step % 2 != 0) != (s % 2 != 0);
      if (pack > 1) {
        for (std::size_t k = across; k < touches.size(); k += pack) {
          Vec2<Pair> j[16];
          std::size_t const end = std::min(k + pack, touches.size());
          for (std::size_t n = k; n < end; ++n) j[n - k] = pull(world, n, by, change);
          for (std::size_t n = k; n < end; ++n) exert(world, touches[n], later[n] = j[n - k], change);
        }
      } else
      for (std::size_t k = across; k < touches.size(); ++k)
        relax(world, backwards ? touches.size() - 1 - (k - across) : k, by, change);
      ++world.counts.damping_passes;
    }
    if (sample) start = world.motion;
    for (std::size_t i = 0; i < world.size(); ++i) {
      world.motion[i].velocity += change[i].velocity;
      world.motion[i].spin += change[i].spin;
    }
    if (sample) {
      double const rate = 1 / dt;
      for (std::size_t k = 0; k < touches.size(); ++k) {
        auto const a = contact_of(world, touches[k], start), b = contact_of(world, touches[k], world.motion);
        Vec2<double> const mean = 0.5 * (wide(a.velocity) + wide(b.velocity));
        auto const f = rate * (wide(total[k]) + wide(later[k]));
        sample->add_dissipative(f, wide(touches[k].separation), -dot(f, mean));
      }
    }
    for (std::size_t i = 0; i < world.size(); ++i)
      world.position[i] += world.time_step() * world.motion[i].velocity;
    world.finish_step();
  }

 private:
  Vec2<Pair> pull(World& world, std::size_t k, IncrementBy const& by, Motions const& felt) {
    Touch<Pair> t = touches[k];
    t.velocity_shift = 0;
    auto const c = contact_of(world, t, felt);
    Pair const n = static_cast<Pair>(by.normal[t.big] * by.mu_n[t.big]);
    Pair const s = static_cast<Pair>(by.tangential[t.big] * by.mu_t[t.big]);
    return (s - n) * dot(c.velocity, t.normal) * t.normal - s * c.velocity;
  }

  void relax(World& world, std::size_t k, IncrementBy const& by, Motions& motion) {
    auto const& t = touches[k];
    Vec2<Pair> j = pull(world, k, by, motion);
    Pair const n = dot(later[k], t.normal);
    // own impulse of an earlier sweep counts as not yet given
    Vec2<Pair> const own_n = n * t.normal, own_t = later[k] - own_n;
    Vec2<Pair> const next = j + static_cast<Pair>(by.normal[t.big]) * own_n +
                            static_cast<Pair>(by.tangential[t.big]) * own_t;
    exert(world, t, next - later[k], motion);
    later[k] = next;
  }

  void relax_together(World& world, double dt, std::size_t across) {
    start = change;
    parts.assign(world.size(), 0);
    for (std::size_t k = 0; k < across; ++k) ++parts[touches[k].i], ++parts[touches[k].j];
    std::vector<IncrementBy> by;
    for (int n = 0; n <= 12; ++n)
      by.emplace_back(world.law, world.table, share, dt, n == 0 ? 1 : n, least);
    for (std::size_t k = 0; k < across; ++k) {
      auto const& t = touches[k];
      int const n = jacobi_parts > 0 ? jacobi_parts : std::max(parts[t.i], parts[t.j]);
      later[k] = pull(world, k, by[n], start);
      exert(world, t, later[k], change);
    }
    ++world.counts.damping_passes;
  }
};

}  // namespace bagnold::accuracy
