// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_stepper.hpp"

namespace bagnold {

/// Pass that calls a member function of a step or of a drive on blocks.
template <class Step>
class PassOf final : public BlockPass {
 public:
  using Run = BlockReport (Step::*)(BlockSystem const&, std::uint32_t b, StepAt const&,
                                    typename Step::Force* scratch) const;

  PassOf(Step const& step, Run run, PassFacts const& facts)
      : BlockPass(facts), step_(step), run_(run) {}

  BlockReport run(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                  void* scratch) const override {
    return (step_.*run_)(s, b, at, static_cast<typename Step::Force*>(scratch));
  }

 private:
  Step const& step_;
  Run run_;
};

}  // namespace bagnold
