// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "src/config/rate_schedule.hpp"

namespace bagnold {

/// Strain rates of a run whose pieces are decided on as it goes: those so far, the last of which
/// does not end.
class PieceHistory final : public RateSchedule {
 public:
  explicit PieceHistory(double rate) : pieces_{{0, rate, {}}} {}

  /// A history from its numbers().
  explicit PieceHistory(std::vector<double> const& numbers);

  Stretch at(std::int64_t step) const override;
  DoubleDouble strain_before(Stretch const& stretch) const override;
  bool scales_motions() const override { return false; }

  /// Begins a piece. strain: from step 0.
  void begin(std::int64_t step, double rate, DoubleDouble const& strain);

  /// Forgets the pieces that ended before a step.
  void forget_before(std::int64_t step);

  /// All that it knows, for a checkpoint.
  std::vector<double> numbers() const;

 private:
  struct Piece {
    std::int64_t begin;
    double rate;          ///< [1/tau_e]
    DoubleDouble strain;  ///< where it begins, from step 0
  };
  std::vector<Piece> pieces_;  ///< in their order
};

}  // namespace bagnold
