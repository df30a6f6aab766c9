// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/clock.hpp"
#include "src/engine/quasi_static/near_pairs.hpp"
#include "src/engine/quasi_static/step_equations.hpp"

namespace bagnold::quasi_static {

/// A time within a step.
struct Moment {
  Clock const& clock;
  std::int64_t step;
  double part = 0;  ///< of the step, 0 to 1
};

/// Pairs that may touch, and the positions of the disks at the search: at the beginning of a step,
/// or within a step in which disks move far.
class PairList {
 public:
  explicit PairList(double skin) : skin_(skin) {}  ///< [d_s]

  /// Searches for the pairs of disks in the box at a moment.
  void build(Material const& material, std::vector<Vec2<Real>> position, Moment const& now);

  /// Box at a moment, with its offset counted from the beginning of the step of this list, or of
  /// another one.
  ShearedBox box(Moment const& now) const { return box(now, mark_); }
  static ShearedBox box(Moment const& now, ShearMark const& mark);

  /// Disk with the largest non-affine displacement.
  struct Farthest {
    double moved2 = 0;  ///< [d_s^2]
    std::size_t disk = 0;
  };
  Farthest farthest(std::vector<Vec2<Real>> const& position, Moment const& now) const;

  /// True if the list holds every pair that can touch, where disks may use `share` of the skin.
  bool holds(std::vector<Vec2<Real>> const& position, Moment const& now, double share = 1) const;

  bool is_of(Moment const& now) const { return mark_.step == now.step && part_ == now.part; }
  bool is_within_a_step() const { return part_ > 0; }

  /// Pairs that may be in contact while the list lasts.
  std::vector<NearPair> contacts() const;

  std::vector<NearPair> const& pairs() const { return pairs_; }
  std::vector<Vec2<Real>> const& position() const { return at_build_; }
  std::int64_t step() const { return mark_.step; }
  double skin() const { return skin_; }

 private:
  double strain(Moment const& now) const;
  void search(Material const& material);

  double skin_;
  ShearMark mark_;   ///< of the step
  double part_ = 0;  ///< of the step done
  ShearedBox box_{};
  std::vector<Vec2<Real>> at_build_;  ///< [N], in the box, [d_s]
  std::vector<NearPair> pairs_;
};

}  // namespace bagnold::quasi_static
