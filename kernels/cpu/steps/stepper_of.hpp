// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "kernels/cpu/islands/binary_collisions.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_sums.hpp"

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

/// Pass of a BlockStep, one of its members.
template <class Step>
class PassOf final : public BlockPass {
 public:
  using Run = BlockReport (Step::*)(BlockSystem const&, std::uint32_t b, StepAt const&,
                                    typename Step::Force* scratch) const;

  PassOf(Step const& step, Run run, Awaits awaits, bool sampled)
      : BlockPass(awaits, sampled), step_(step), run_(run) {}

  BlockReport run(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                  void* scratch) const override {
    return (step_.*run_)(s, b, at, static_cast<typename Step::Force*>(scratch));
  }

 private:
  Step const& step_;
  Run run_;
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
      : BlockStepper(needs_of(drive != nullptr)),
        step_(law, repulsion, table, time_step, std::move(drive)) {
    Step::each_pass(adding_to(many));
    if constexpr (requires { Step::each_pass_for_few(adding_to(few)); }) {
      if (needs.driven) return;
      Step::each_pass_for_few(adding_to(few));
      using Pairs = BinaryCollisions<Law, Repulsion, typename Step::Scheme>;
      lone_pairs = std::make_unique<LonePairsOf<Pairs>>(
          Pairs{law, repulsion, table, time_step, 0, step_.second_stage()});
    }
  }

 private:
  static StepNeeds needs_of(bool driven) {
    StepNeeds needs = Step::needs;
    needs.driven = driven;
    return needs;
  }

  auto adding_to(BlockPasses& passes) {
    return [&](typename PassOf<Step>::Run run, Awaits awaits, bool sampled = false) {
      passes.push_back(std::make_unique<PassOf<Step>>(step_, run, awaits, sampled));
    };
  }

  Step step_;
};

}  // namespace bagnold
