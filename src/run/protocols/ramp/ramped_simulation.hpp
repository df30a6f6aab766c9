// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "src/config/ramp.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// A simulation whose strain rate follows a ramp. Each piece is a simulation of its own at one
/// rate, from the last state of the piece before, velocities and spins scaled by the ratio of the
/// rates (P2 Eqs. 40-41). A step where a piece begins belongs to it.
class RampedSimulation final : public Simulation {
 public:
  /// A simulation at one rate, [1/tau_e]. Its steps are those of the whole ramp.
  using Make = std::function<std::unique_ptr<Simulation>(double strain_rate, Snapshot&&)>;

  /// `snapshot`: as snapshot() gives it, or the first one of a state whose velocities belong to the
  /// rate of the first piece.
  RampedSimulation(Ramp const& ramp, Make make, Snapshot&& snapshot);

  int columns() const override { return piece_->columns(); }
  std::int64_t step() const override { return piece_->step(); }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;

  /// Of the piece, but initial_offset is that at step 0 of the ramp.
  Snapshot snapshot() const override;
  void give_back_scratch() override { piece_->give_back_scratch(); }
  State state() const override { return piece_->state(); }

 private:
  double offset_of(Ramp::Piece const& piece, State const& box) const;
  void next_piece();

  Ramp ramp_;
  Make make_;
  double initial_offset_;  ///< at step 0, [d_s]
  std::unique_ptr<Simulation> piece_;
};

}  // namespace bagnold
