// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "kernels/cpu/steps/block_system.hpp"
#include "kernels/physics/laws/pair_force.hpp"

namespace bagnold {

/// Pairs of one pack that touch, for observers of the block's pair loop.
struct PackOfPairs {
  simd::LocalPair const* pairs;  ///< [width]
  simd::Mask touching;
  PairForce<simd::Pack> const& force;
};

struct NoPackObserver {
  void operator()(PackOfPairs const&) const {}
};

/// DiskPower of a pack of disks.
struct PackPower {
  simd::Pack dissipation = 0.0, torque = 0.0;
};

/// Observer that keeps the largest overlap and counts contacts.
struct OverlapBound {
  simd::Pack largest = 0.0;
  std::uint32_t touching = 0;
  void operator()(PackOfPairs const& p) {
    touching += __builtin_popcount(p.touching.lanes());
    largest = max(largest, zero_unless(p.touching, p.force.relative_overlap));
  }
};

/// Forces on the disks of one block from one of its near lists, a pack of pairs at once.
///
/// Pairs are added in the order of the list, so the bits depend neither on threads nor on when the
/// list was pruned: a pair that does not touch adds zero. Counting: also counts each disk's
/// contacts.
template <ContactLaw Law, class Repulsion, bool Counting = false>
struct BlockForces {
  static constexpr bool rotates = Law::rotates;
  using Force = std::conditional_t<rotates || Counting, simd::TurningForce, simd::Force>;

  Law law;
  Repulsion repulsion;

  /// force: [block.local()], zeroed here; uses the pairs of the inner list.
  template <class Observer>
  void evaluate(BlockSystem const& system, Block const& block, BlockState const& state,
                Force* force, Observer&& observe) const {
    clear(block, force);
    add(system, block, inner_list, state, force, observe);
  }

  static void clear(Block const& block, Force* force) {
    std::fill_n(force, block.local(), Force{});
  }

  /// Adds the forces of the pairs of a near list to force.
  template <class Observer>
  void add(BlockSystem const& system, Block const& block, NearList list, BlockState const& state,
           Force* force, Observer&& observe) const {
    for (int c = 0; c < pair_classes; ++c) add(c, system, block, list, state, force, observe);
  }

  /// Adds the forces of the pairs of one class.
  template <class Observer>
  void add(int pair_class, BlockSystem const& system, Block const& block, NearList list,
           BlockState const& state, Force* force, Observer&& observe) const {
    double const* spins = nullptr;
    if constexpr (rotates) spins = state.spin.data() + block.first;
    add_class(pair_class, system.blocks.near[list].data() + block.pairs[pair_class],
              block.near[list][pair_class], state.record.data() + block.first, spins, force,
              observe);
  }

 private:
  /// Data of a pack of pairs, loaded from memory.
  struct Loaded {
    simd::Records difference;
    simd::Pack distance2, spins;
  };

  BAGNOLD_INLINE static Loaded load(simd::LocalPair const* pairs, simd::Record const* records,
                                    double const* spins, double weight) {
    Loaded l;
    l.difference = simd::load_differences(records, pairs);
    if constexpr (rotates) l.spins = simd::load_sums(spins, pairs, weight);
    l.distance2 = fma(l.difference.x, l.difference.x, l.difference.y * l.difference.y);
    return l;
  }

  /// Each pack is loaded before the forces of the previous one are evaluated, so that loads and
  /// arithmetic overlap.
  template <class Observer>
  void add_class(int pair_class, simd::LocalPair const* pairs, std::uint32_t count,
                 simd::Record const* records, double const* spins, Force* force,
                 Observer& observe) const {
    using simd::Pack;
    if (count == 0) return;
    Real const distance = class_distance(pair_class);
    Pack const reach2 = distance * distance, inverse_distance = 1 / distance;
    Law const law = this->law;  // local: stores of forces cannot alias it
    Repulsion const repulsion = this->repulsion;
    // thetadot_a d_a + thetadot_b d_b as d_a (thetadot_a + d_b/d_a thetadot_b); a is the smaller
    // one.
    Real const diameter_a = pair_class == 2 ? big_diameter : small_diameter;
    Real const weight = pair_class == 1 ? big_diameter / small_diameter : 1;
    Loaded next = load(pairs, records, spins, weight);
    for (std::uint32_t k = 0; k < count; k += simd::width) {
      Loaded const now = next;
      next = load(pairs + (k + simd::width < count ? k + simd::width : 0), records, spins, weight);
      simd::Mask const touching = now.distance2 < reach2;
      auto const& d = now.difference;
      auto const f =
          pair_force<Law, Repulsion, Pack>(law, repulsion, {d.x, d.y}, now.distance2, {d.vx, d.vy},
                                           inverse_distance, diameter_a * now.spins);
      Pack const x = zero_unless(touching, f.elastic.x + f.dissipative.x);
      Pack const y = zero_unless(touching, f.elastic.y + f.dissipative.y);
      Pack torque_per_diameter = 0.0;
      if constexpr (rotates)
        torque_per_diameter = zero_unless(touching, f.torque_per_diameter(inverse_distance));
      if constexpr (Counting)
        simd::scatter(force, pairs + k, x, y, torque_per_diameter, zero_unless(touching, 1.0));
      else if constexpr (rotates)
        simd::scatter(force, pairs + k, x, y, torque_per_diameter);
      else
        simd::scatter(force, pairs + k, x, y);
      observe(PackOfPairs{pairs + k, touching, f});
    }
  }
};

}  // namespace bagnold
