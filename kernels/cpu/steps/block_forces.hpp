// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "kernels/cpu/steps/block_system.hpp"
#include "kernels/cpu/steps/pair_loop.hpp"
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
    Real const distance = class_distance(pair_class);
    each_pack(system.blocks, block, list, pair_class,
              Evaluate<std::remove_reference_t<Observer>>{
                  PairClass(pair_class), distance * distance, law, repulsion,
                  state.record.data() + block.first, spins, force, observe});
  }

 private:
  /// Body of the pair loop.
  template <class Observer>
  struct Evaluate {
    struct Data {
      simd::Records difference;
      simd::Pack distance2, spins;
    };

    PairClass of;
    simd::Pack reach2;
    Law law;
    Repulsion repulsion;
    simd::Record const* records;
    double const* spins;
    Force* force;
    Observer& observe;

    BAGNOLD_INLINE Data load(simd::LocalPair const* pairs) const {
      Data data;
      data.difference = simd::load_differences(records, pairs);
      if constexpr (rotates) data.spins = simd::load_sums(spins, pairs, of.ratio);
      data.distance2 =
          fma(data.difference.x, data.difference.x, data.difference.y * data.difference.y);
      return data;
    }

    BAGNOLD_INLINE void operator()(simd::LocalPair const* pairs, std::uint32_t,
                                   Data const& now) const {
      using simd::Pack;
      simd::Mask const touching = now.distance2 < reach2;
      auto const& d = now.difference;
      auto const f =
          pair_force<Law, Repulsion, Pack>(law, repulsion, {d.x, d.y}, now.distance2, {d.vx, d.vy},
                                           of.inverse_distance, of.diameter * now.spins);
      Pack const x = zero_unless(touching, f.elastic.x + f.dissipative.x);
      Pack const y = zero_unless(touching, f.elastic.y + f.dissipative.y);
      Pack torque_per_diameter = 0.0;
      if constexpr (rotates)
        torque_per_diameter = zero_unless(touching, f.torque_per_diameter(of.inverse_distance));
      if constexpr (Counting)
        simd::scatter(force, pairs, x, y, torque_per_diameter, zero_unless(touching, 1.0));
      else if constexpr (rotates)
        simd::scatter(force, pairs, x, y, torque_per_diameter);
      else
        simd::scatter(force, pairs, x, y);
      observe(PackOfPairs{pairs, touching, f});
    }
  };
};

/// Adds the damping of a pack of pairs to the forces on their disks, where they touch.
template <class Force>
BAGNOLD_INLINE void scatter_damping(Force* force, simd::LocalPair const* pairs, simd::Mask touching,
                                    PairForce<simd::Pack> const& f, bool rotates,
                                    simd::Pack const& inverse_distance) {
  simd::Pack torque_per_diameter = 0.0;
  if (rotates) torque_per_diameter = zero_unless(touching, f.torque_per_diameter(inverse_distance));
  simd::scatter(force, pairs, zero_unless(touching, f.dissipative.x),
                zero_unless(touching, f.dissipative.y), torque_per_diameter);
}

}  // namespace bagnold
