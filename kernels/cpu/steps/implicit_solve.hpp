// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/blocks/blocks.hpp"
#include "kernels/physics/schemes/chebyshev.hpp"

namespace bagnold {

/// Iterations of an ImplicitScheme in a step, for the changes w of all motions: a record {v_x, v_y,
/// thetadot, -} a disk. Iteration k makes w_k+2 from `now`, w_k+1.
struct ImplicitSolve {
  using Records = Blocks::Array<simd::Record>;

  Records iterate[2];                ///< by slot, in turns; empty where no scheme iterates
  Blocks::Array<double> separation;  ///< r_ij of the contact list, x and y of each pack, if kept
  ChebyshevIterations iterations{0, 2};

  int passes() const { return iterations.count; }

  /// start: a, which is used as w_1.
  Records const& now(int k, Records const& start) const {
    return k == 0 ? start : iterate[(k - 1) % 2];
  }
  Records const& next(int k) const { return iterate[k % 2]; }

  Records const& solution() const { return next(passes() - 1); }
};

}  // namespace bagnold
