// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Length of lookaheads, and whether near pairs are stepped from the first (cautious) or only once
/// they turn out to have been missed. Finds the cheapest setting by trials: most lookaheads use the
/// best one known, a few now and then one of its neighbours, which replaces it if it costs less.
/// Costs are counted, not timed, so that the choice is the same on every machine.
class LookaheadTuning {
 public:
  static constexpr int shortest = 4, longest = 14;  ///< log2 of steps

  std::int64_t steps() const { return std::int64_t{1} << level(); }
  bool cautious() const { return trying() == 3 ? best_cautious_ == 0 : best_cautious_ != 0; }

  /// Records a lookahead of full length and its cost, [cycles a step].
  void done(Real cost) {
    if (trying() == 0) {
      cost_ = cost_ == 0 ? cost : 0.875 * cost_ + 0.125 * cost;
      next();
      return;
    }
    trial_cost_ += cost / tries;
    if (phase_ % period != period - 1) return next();
    if (trial_cost_ < 0.96 * cost_) take_over();
    trial_cost_ = 0;
    next();
  }

  /// Records a lookahead that failed. Returns whether a shorter one is possible.
  bool refused() {
    bool const tried = trying() != 0;
    phase_ += period - phase_ % period;  // no more of that
    trial_cost_ = 0;
    if (tried) return true;
    if (best_level_ == shortest) return false;
    --best_level_;
    cost_ = 0;
    return true;
  }

  /// Visits the numbers that a bit-for-bit restart needs.
  template <class Visit>
  void for_each_memory(Visit const& visit) {
    visit("lookahead_level", best_level_);
    visit("lookahead_cautious", best_cautious_);
    visit("lookahead_phase", phase_);
    visit("lookahead_cost", cost_);
    visit("lookahead_trial_cost", trial_cost_);
  }

 private:
  static constexpr std::int64_t tries = 4, period = 36;

  /// Setting to use next. 0: the best known; 1: longer, 2: shorter, 3: cautious or not, the other
  /// way.
  int trying() const {
    if (phase_ % period < period - tries) return 0;
    auto const way = static_cast<int>(phase_ / period % 3) + 1;
    if ((way == 1 && best_level_ == longest) || (way == 2 && best_level_ == shortest)) return 3;
    return way;
  }

  int level() const {
    int const way = trying();
    return static_cast<int>(best_level_) + (way == 1) - (way == 2);
  }

  void take_over() {
    int const way = trying();
    best_level_ += (way == 1) - (way == 2);
    if (way == 3) best_cautious_ = best_cautious_ == 0;
    cost_ = trial_cost_;
  }

  void next() { ++phase_; }

  std::int64_t best_level_ = 6;
  std::int64_t best_cautious_ = 0;
  std::int64_t phase_ = 0;  ///< lookaheads
  Real cost_ = 0;           ///< of the best known, running mean; 0: not known
  Real trial_cost_ = 0;
};

}  // namespace bagnold
