// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/implicit_block_step.hpp"
#include "kernels/cpu/steps/predict_correct_block_step.hpp"
#include "kernels/cpu/steps/stepper_of.hpp"
#include "kernels/cpu/steps/two_stage_block_step.hpp"
#include "src/engine/blocks/make_block_engine.hpp"
#include "src/engine/drives/drive_engines.hpp"
#include "src/engine/with_physics.hpp"

namespace bagnold {

/// To be instantiated once for each law and level (src/engine/levels).
template <ContactLaw Law>
std::unique_ptr<BlockStepper> make_stepper(EngineInput const& input) {
  return with_physics_of<Law>(
      input.physics,
      [&]<class R, class S>(Law const& law, R const& repulsion,
                            S) -> std::unique_ptr<BlockStepper> {
        using Step = BlockStep<Law, R, S>;
        return std::make_unique<StepperOf<Step>>(
            law, repulsion, input.species, input.time_step,
            make_block_drive<typename Step::Force, Law::rotates>(input.drive));
      });
}

}  // namespace bagnold
