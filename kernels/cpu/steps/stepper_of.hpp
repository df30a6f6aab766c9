// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>
#include <utility>

#include "kernels/cpu/islands/binary_collisions.hpp"
#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/cpu/steps/block_sums.hpp"

namespace bagnold {

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
        step_(law, repulsion, table, time_step, std::move(drive)),
        table_(table) {}

  BlockReport predict(BlockSystem const& s, std::uint32_t b, ShearedBox const& box,
                      void* force) const override {
    return step_.predict(s, b, box, forces(force));
  }

  BlockReport correct(BlockSystem const& s, std::uint32_t b, ShearedBox const& box, void* force,
                      bool observed, FlightDeviation* seen) const override {
    if (seen != nullptr) return step_.correct(s, b, box, forces(force), observed, *seen);
    return step_.correct(s, b, box, forces(force), observed, NoFlightDeviation{});
  }

  void iterate(BlockSystem const& s, std::uint32_t b, int k, void* force) const override {
    if constexpr (iterates)
      step_.iterate(s, b, k, forces(force));
    else
      not_of_this_form();
  }

  BlockReport predict_few(BlockSystem const& s, ActiveDisks const& active, std::uint32_t b,
                          ShearedBox const& box, void* force) const override {
    if constexpr (iterates)
      not_of_this_form();
    else
      return step_.predict_few(s, active, b, box, forces(force));
  }

  BlockReport correct_few(BlockSystem const& s, ActiveDisks const& active, std::uint32_t b,
                          ShearedBox const& box, void* force, bool observed,
                          simd::Record* moved) const override {
    if constexpr (iterates)
      not_of_this_form();
    else
      return step_.correct_few(s, active, b, box, forces(force), observed, moved);
  }

  BlockSums measure(BlockSystem const& s, std::uint32_t b, Real strain_rate,
                    void* force) const override {
    return measure_block(step_, s, b, strain_rate, forces(force));
  }

  DrivePower drive_power(BlockSystem const& s, std::uint32_t b, Real strain_rate,
                         void* force) const override {
    return step_.drive_power(s, s.blocks.block(b), strain_rate, forces(force));
  }

  BinaryOutcome collide(BinaryDisk* a, BinaryDisk* b, int count, std::int64_t steps,
                        Real strain_rate, FlightTimes const& flights, SampleTimes const& times,
                        BlockSums* sums, LaneDetector* detector) const override {
    if constexpr (iterates) {
      not_of_this_form();
    } else {
      BinaryCollisions<Law, Repulsion, typename Step::Scheme> const collisions{
          step_.forces.law, step_.forces.repulsion, table_, step_.time_step,
          strain_rate,      step_.second_stage()};
      if (detector != nullptr)
        return collisions.run(a, b, count, steps, flights, times, sums, *detector);
      return collisions.run(a, b, count, steps, flights, times, sums, NoLaneDetector{});
    }
  }

 private:
  static constexpr bool iterates = ImplicitScheme<typename Step::Scheme>;

  /// Never reached: engines read `needs` before they call.
  [[noreturn]] static void not_of_this_form() {
    throw std::logic_error("a step that the scheme has not");
  }

  static StepNeeds needs_of(bool driven) {
    StepNeeds needs = Step::needs;
    needs.driven = driven;
    return needs;
  }

  static typename Step::Force* forces(void* scratch) {
    return static_cast<typename Step::Force*>(scratch);
  }

  Step step_;
  SpeciesTable table_;
};

}  // namespace bagnold
