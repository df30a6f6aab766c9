// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "src/config/scene.hpp"
#include "src/run/bias/judge.hpp"
#include "src/run/bias/methods.hpp"

namespace bagnold::bias {

/// What was found out about the method of a run.
struct Findings {
  /// A verdict that differs from the one before, and after how many pairs.
  struct Look {
    std::size_t pairs;
    Verdict verdict;
  };

  std::size_t pairs = 0;
  double tolerance = 0;
  std::int64_t coarse_steps = 0, fine_steps = 0;  ///< of all stretches
  Methods methods;
  Judgement judgement;  ///< of all pairs; its verdict that of the last look
  std::vector<Look> looks;
};

/// Pairs after which a method without a verdict is `open`.
inline constexpr std::size_t most_pairs = 20;

/// Pairs of all replicas, and when the next ones begin.
///
/// Replicas take pairs in rounds, each one pair at the same place of a grid. After 4, 6, 9, 13 and
/// 20 pairs, and once there is a verdict after each round, all pairs so far are judged together.
/// Without a verdict the next round is at the next place, with one at twice the strain. So the
/// course depends on the pairs alone, not on when they were taken.
class Course {
 public:
  Course(Scene const& scene, std::size_t replicas);

  Methods const& methods() const { return methods_; }
  std::vector<Pair> const& pairs(std::size_t replica) const { return of_[replica]; }

  /// Step from which a replica takes its next pair; if it has that of this round, the first that
  /// the next round may have.
  std::int64_t next(std::size_t replica) const;

  /// True if a replica takes a pair at next(); false: it waits there until others have theirs.
  bool takes(std::size_t replica) const { return of_[replica].size() == rounds_; }

  void add(std::size_t replica, Pair const& pair);

  /// Numbers of the pairs of a replica, for a checkpoint; and back.
  std::vector<double> save(std::size_t replica) const;
  void load(std::size_t replica, std::vector<double> const& numbers);

  Findings findings() const;

 private:
  void end_round();
  std::vector<Pair> all() const;
  Judgement judged() const;

  double tolerance_, collision_loss_error_;
  Methods methods_;
  std::vector<std::vector<Pair>> of_;  ///< [R], in the order of rounds
  std::size_t rounds_ = 0;             ///< complete
  std::size_t looks_ = 0;              ///< of the schedule
  std::int64_t place_ = 1;             ///< of the present round on the grid
  Verdict verdict_ = Verdict::none;
  std::vector<Findings::Look> verdicts_;
};

/// Name of a replica's pairs among the arrays of a checkpoint.
inline constexpr char pairs_name[] = "bias_pairs";

}  // namespace bagnold::bias
