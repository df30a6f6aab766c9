// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/physics/species.hpp"
#include "kernels/cpu/steps/block_forces.hpp"

namespace bagnold {

/// Positions and velocities of all blocks, slot by slot.
struct BlockState {
  Blocks::Array<simd::Record> record;
  Blocks::Array<double> spin;  ///< thetadot, [1 / tau_e]; empty if the law does not rotate
};

/// A disk where its image is.
inline simd::Record at_image(simd::Record record, Image const& image, ShearedBox const& box) {
  Vec2<Real> const shift = box.shift(image);
  record.x += shift.x;
  record.y += shift.y;
  record.vx += box.velocity_shift(image);
  return record;
}

/// Reads a block's disks in the order of memory, which the processor foresees and fetches ahead: the
/// order of pairs, in which they are visited next, it does not.
inline void bring_near(Block const& block, BlockState const& state) {
  constexpr std::uint32_t line = 64 / sizeof(simd::Record);
  simd::Record const volatile* const record = state.record.data() + block.first;
  for (std::uint32_t i = 0; i < block.padded; i += line) static_cast<void>(record[i].x);
}

/// Copies the disks of other blocks, and images, into a block's halo.
inline void refresh_halo(Blocks const& blocks, Block const& block, BlockState const& state,
                         ShearedBox const& box) {
  auto const* halo = blocks.halo.data() + block.halo_first;
  auto* const record = state.record.data();
  auto const to = block.first + block.padded;
  if (blocks.beyond_cache()) bring_near(block, state);
  for (std::uint32_t h = 0; h < block.halo; ++h) {
    record[to + h] = at_image(record[halo[h].index()], halo[h].image(), box);
    if (state.spin.extent(0) != 0) state.spin(to + h) = state.spin(halo[h].index());
  }
}

/// Largest (v - gammadot y x^)^2 of a block's disks, [d_s^2 / tau_e^2].
inline Real fastest2_of(Block const& block, BlockState const& state, Real strain_rate) {
  simd::Pack fastest2 = 0.0;
  for (std::uint32_t i = 0; i < block.padded; i += simd::width) {
    auto const r = simd::load_records(state.record.data() + block.first + i);
    simd::Pack const ux = fnma(strain_rate, r.y, r.vx);
    fastest2 = max(fastest2, fma(ux, ux, r.vy * r.vy));
  }
  return simd::largest(fastest2);
}

/// What a step tells of a block; each half of the step adds its part.
struct BlockReport {
  Real fastest2 = 0;          ///< largest (v - gammadot y x^)^2, [d_s^2 / tau_e^2]
  Real largest_overlap = 0;   ///< relative
  std::uint32_t touching = 0;  ///< pairs, those across the edge included
  Real poison = 0;            ///< 0, or no number where a motion is none

  BlockReport& operator+=(BlockReport const& o) {
    fastest2 = std::max(fastest2, o.fastest2);
    largest_overlap = std::max(largest_overlap, o.largest_overlap);
    touching += o.touching;
    poison += o.poison;
    return *this;
  }
};

/// What steps of a scheme cost, by which engines choose, [cycles a disk-step]; from times of CD_n and
/// CD_rot (0.76 to 0.78, Q = 1 and 50, rates 1e-4 and 1e-5).
struct StepCosts {
  Real by_itself;    ///< of a disk without contacts where all disks are stepped
  Real contact;      ///< and for each contact it has
  Real dense_below;  ///< contacts per disk below which dense steps cost less than contact-rich ones
};

/// Keeps the largest overlap and counts contacts.
struct OverlapWatch {
  simd::Pack largest = 0.0;
  std::uint32_t touching = 0;
  void operator()(PackOfPairs const& p) {
    touching += __builtin_popcount(p.touching.lanes());
    largest = max(largest, zero_unless(p.touching, p.force.relative_overlap));
  }
};

/// DiskPower of eight disks.
struct PackPower {
  simd::Pack dissipation = 0.0, torque = 0.0;
};

/// All blocks, and what a step of a scheme needs of them. The scheme has two halves with a barrier between
/// them, as `trial` of a block is read by its neighbours: see BlockStep, TwoStageBlockStep.
template <ContactLaw L, class R, bool Counting>
struct BlockSystem {
  using Law = L;
  using Repulsion = R;
  using Forces = BlockForces<Law, Repulsion, Counting>;
  using Force = typename Forces::Force;
  static constexpr bool rotates = Law::rotates;

  Forces forces;
  Blocks blocks;
  Blocks::Array<Species> species;  ///< by slot
  SpeciesTable table;
  BlockState now;
  BlockState trial;
  Real time_step;

  /// What does not depend on disks.
  void set_laws(Law const& law, SpeciesTable const& of_species, Real dt) {
    forces.law = law;
    table = of_species;
    time_step = dt;
  }
  void take_laws(BlockSystem const& from) { set_laws(from.forces.law, from.table, from.time_step); }

  /// (d_i thetadot_i + d_j thetadot_j) / (d_i + d_j) of two slots, [1/tau_e].
  Real common_spin(std::uint32_t i, std::uint32_t j) const
    requires rotates
  {
    Real const a = table.diameter[species(i)], b = table.diameter[species(j)];
    return (a * now.spin(i) + b * now.spin(j)) / (a + b);
  }

  /// Likewise of a pair of a class, halo included; 0 if the law does not rotate.
  Real common_spin(Block const& block, int pair_class, simd::LocalPair const& pair) const {
    if constexpr (rotates) {
      Real const a = pair_class == 2 ? big_diameter : small_diameter;
      Real const b = pair_class == 0 ? small_diameter : big_diameter;
      return (a * now.spin(block.first + pair.a()) + b * now.spin(block.first + pair.b())) /
             (a + b);
    }
    return 0;
  }

  /// force: [block.local()], zeroed here.
  template <class Observer>
  void evaluate(Block const& block, BlockState const& state, Force* force,
                Observer&& observe) const {
    clear(block, force);
    add_forces(block, inner_list, state, force, observe);
  }

  static void clear(Block const& block, Force* force) {
    std::fill_n(force, block.local(), Force{});
  }

  /// Adds to force what the pairs of a near list exert.
  template <class Observer>
  void add_forces(Block const& block, NearList list, BlockState const& state, Force* force,
                  Observer&& observe) const {
    for (int c = 0; c < pair_classes; ++c)
      add_forces(c, block, list, state, force, observe);
  }

  /// Those of one class.
  template <class Observer>
  void add_forces(int pair_class, Block const& block, NearList list, BlockState const& state,
                  Force* force, Observer&& observe) const {
    double const* spins = nullptr;
    if constexpr (rotates) spins = state.spin.data() + block.first;
    forces(pair_class, blocks, block, list, state.record.data() + block.first, spins, force, observe);
  }

  static simd::Pack diameter_of(simd::Mask big) {
    return select(big, simd::Pack(big_diameter), simd::Pack(small_diameter));
  }

  /// What turns forces on eight disks into changes of motion, by species.
  struct Kick {
    simd::Pack mass[2], inertia[2];

    Kick(SpeciesTable const& table, Real time) {
      for (int s = 0; s < 2; ++s) {
        mass[s] = time * table.inverse_mass[s];
        inertia[s] = time * table.diameter[s] * table.inverse_inertia[s];
      }
    }
    simd::Pack per_mass(simd::Mask big) const { return select(big, mass[1], mass[0]); }  ///< dt / m
    simd::Pack per_inertia(simd::Mask big) const {  ///< dt d / I
      return select(big, inertia[1], inertia[0]);
    }
  };
};

}  // namespace bagnold
