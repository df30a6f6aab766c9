// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/blocks/lookahead_steps.hpp"
#include "src/engine/blocks/lookahead_tuning.hpp"
#include "src/engine/blocks/single_steps.hpp"
#include "src/engine/drive_columns.hpp"
#include "src/engine/engine_input.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// A scheme on blocks of neighbouring disks, pairs and disks a pack at a time: step by step where
/// contacts are many, in lookaheads where most disks fly freely.
class BlockEngine final : public Simulation {
 public:
  /// Moves the snapshot's arrays into the engine.
  BlockEngine(std::unique_ptr<BlockLoop> loop, std::unique_ptr<BlockStepper> stepper,
              Stepping stepping, EngineInput const& input, Snapshot& snapshot);

  int columns() const override {
    return engine_columns(disks_.system.rotates, disks_.stepper->uses(Uses::drive));
  }
  std::int64_t step() const override { return disks_.system.step; }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  void begin_piece(double strain_rate, double scale) override;
  double strain() const override { return disks_.clock.strain(disks_.system.step); }
  Snapshot snapshot() const override;
  State state() const override;
  void give_back_scratch() override { lists_.give_back_scratch(); }

 private:
  template <class Visit>
  void for_each_memory(Visit const& visit);
  template <class Visit>
  void for_each_counter(Visit const& visit);

  void advance_one(Sampling const& sampling, OpenWindows& windows);
  void follow(RateChange const& change);
  void advance_step(Sampling const& sampling, OpenWindows& windows);
  std::int64_t lookahead_end() const;  ///< of the next one, in a run without an end
  void advance_lookahead(Sampling const& sampling, OpenWindows& windows);
  void step_through(Lookahead const& lookahead, Sampling const& sampling, OpenWindows& windows);
  void set_allowance(std::int64_t length);
  void weigh(Lookahead const& lookahead, Real contacts, Real stepped_through);
  Real cost_of(Lookahead const& lookahead) const;

  Stepping stepping_;
  BlockDisks disks_;
  BlockLists lists_;
  ContactDetector detector_;
  SingleSteps single_;
  LookaheadSteps lookahead_;
  LookaheadTuning tuning_;
  LookaheadGain gain_;
  bool looking_ahead_ = false;
  std::int64_t allowance_steps_ = 0;  ///< length of the lookaheads that the allowance is for
  std::int64_t lookaheads_refused_ = 0;
};

}  // namespace bagnold
