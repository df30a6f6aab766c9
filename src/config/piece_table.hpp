// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "src/config/rate_schedule.hpp"

namespace bagnold {

/// Pieces of a run, each at one strain rate of any sign or zero, repeated cycle after cycle.
class PieceTable final : public RateSchedule {
 public:
  /// A piece of a cycle. Strains are from the beginning of the cycle to that of the piece.
  struct Piece {
    std::int64_t begin = 0;  ///< first step, from that of the cycle
    double rate = 0;         ///< [1/tau_e]
    DoubleDouble strain{};
    double path = 0;  ///< strain of both signs added up
  };

  /// Place of a step: cycle and piece, from 0.
  struct Place {
    std::int64_t cycle = 0;
    std::size_t piece = 0;
  };

  explicit PieceTable(double time_step, std::int64_t cycles = 1)
      : time_step_(time_step), cycles_(cycles) {}

  /// Adds a piece at the end of the cycle.
  void add(std::int64_t steps, double rate);

  /// Adds a piece whose strain at the end is known in closed form, from the beginning of the cycle.
  void add(std::int64_t steps, double rate, DoubleDouble const& strain_after);

  Stretch at(std::int64_t step) const override;
  DoubleDouble strain_before(Stretch const& stretch) const override;
  bool scales_motions() const override { return false; }

  Place place(std::int64_t step) const;
  Piece const& operator[](std::size_t piece) const { return pieces_[piece]; }
  std::size_t size() const { return pieces_.size(); }  ///< pieces of a cycle
  std::int64_t cycles() const { return cycles_; }
  std::int64_t cycle_steps() const { return end_.begin; }
  std::int64_t steps() const { return cycles_ * cycle_steps(); }

  /// Steps of a piece of a cycle.
  std::int64_t steps_of(std::size_t piece) const {
    return after(piece).begin - pieces_[piece].begin;
  }

  double strain(std::int64_t step) const;  ///< from step 0
  double path(std::int64_t step) const;    ///< the same, both signs added up

  /// Mean rate over steps begin .. end - 1, [1/tau_e].
  double mean_rate(std::int64_t begin, std::int64_t end) const;

  /// |strain|, both signs added up, over time, [1/tau_e].
  double typical_rate() const;

 private:
  Piece const& after(std::size_t piece) const {
    return piece + 1 < pieces_.size() ? pieces_[piece + 1] : end_;
  }

  double time_step_;  ///< dt, [tau_e]
  std::int64_t cycles_;
  std::vector<Piece> pieces_;
  Piece end_;  ///< where the cycle ends
};

}  // namespace bagnold
