// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "kernels/cpu/islands/binary_collisions.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_sums.hpp"
#include "kernels/cpu/steps/pass_of.hpp"

namespace bagnold {

/// LonePairs of one law, repulsion and scheme.
template <class Collisions>
class LonePairsOf final : public LonePairs {
 public:
  explicit LonePairsOf(Collisions const& collisions) : collisions_(collisions) {}

  BinaryOutcome collide(BinaryDisk* a, BinaryDisk* b, int count, std::int64_t steps,
                        Real strain_rate, FlightTimes const& flights, SampleTimes const& times,
                        BlockSums* sums, LaneDetector* detector) const override {
    Collisions collisions = collisions_;
    collisions.strain_rate = strain_rate;
    if (detector != nullptr)
      return collisions.run(a, b, count, steps, flights, times, sums, *detector);
    return collisions.run(a, b, count, steps, flights, times, sums, NoLaneDetector{});
  }

 private:
  Collisions collisions_;
};

/// BlockStepper of one law, repulsion and scheme. Step: a BlockStep.
template <class Step>
class StepperOf final : public BlockStepper {
 public:
  using Law = typename Step::Law;
  using Repulsion = typename Step::Repulsion;
  using Drive = BlockDrive<typename Step::Force, Step::rotates>;

  /// drive: null for none.
  StepperOf(Law const& law, Repulsion const& repulsion, SpeciesTable const& table, Real time_step,
            std::unique_ptr<Drive const> drive)
      : BlockStepper(Step::costs, Step::scratch),
        step_(law, repulsion, table, time_step),
        drive_(std::move(drive)) {
    Step::each_pass(Adding{*this, many});
    if constexpr (requires { Step::each_pass_for_few(Adding{*this, few}); }) {
      if (drive_) return;  // disks that touch nothing do not fly straight
      Step::each_pass_for_few(Adding{*this, few});
      using Pairs = BinaryCollisions<Law, Repulsion, typename Step::Scheme>;
      lone_pairs = std::make_unique<LonePairsOf<Pairs>>(
          Pairs{law, repulsion, table, time_step, 0, step_.second_stage()});
    }
  }

 private:
  /// Adds passes of the step to a list, and those of the drive if there is one.
  struct Adding {
    StepperOf const& stepper;
    BlockPasses& passes;

    void operator()(typename PassOf<Step>::Run run, PassFacts const& facts = {}) const {
      passes.push_back(std::make_unique<PassOf<Step>>(stepper.step_, run, facts));
    }
    void operator()(DrivePart part) const {
      if (stepper.drive_) passes.push_back(stepper.drive_->pass(part));
    }
  };

  Step step_;
  std::unique_ptr<Drive const> drive_;  ///< null: none
};

}  // namespace bagnold
