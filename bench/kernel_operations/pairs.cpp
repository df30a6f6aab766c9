// SPDX-License-Identifier: BSD-3-Clause
//
// The pair loop of each law, compiled as engines compile it, for count.py to look at. Nothing runs.
#include "kernels/cpu/steps/predict_correct_block_step.hpp"
#include "kernels/physics/laws/cd.hpp"
#include "kernels/physics/laws/cd_n.hpp"
#include "kernels/physics/laws/cd_nt.hpp"
#include "kernels/physics/laws/cd_rot.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/schemes/modified_velocity_verlet.hpp"

namespace bagnold {

template <ContactLaw Law>
struct PairLoop {
  using Step = BlockStep<Law, HarmonicRepulsion, ModifiedVelocityVerlet>;

  /// The evaluation of the second half of a step, which looks at overlaps.
  [[gnu::noinline]] static BlockReport run(Step const& step, BlockSystem const& system,
                                           Block const& block, typename Step::Force* force) {
    OverlapBound overlaps;
    step.forces.evaluate(system, block, system.trial, force, overlaps);
    return {0, simd::largest(overlaps.largest), overlaps.touching, 0};
  }
};

template struct PairLoop<CD>;
template struct PairLoop<CDn>;
template struct PairLoop<CDrot>;
template struct PairLoop<CDnt>;

}  // namespace bagnold
