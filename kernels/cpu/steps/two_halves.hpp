// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_stepper.hpp"

namespace bagnold {

/// Passes of a step of two halves. The halo of a pass is of what the pass before it wrote: `now`,
/// then what the first half left in `trial`.
template <class Step>
struct TwoHalves {
  template <class Add>
  static void each_pass(Add const& add) {
    add(&Step::predict, Awaits::neighbours);
    add(&Step::measure, Awaits::neighbours, true);
    add(&Step::correct, Awaits::own);
  }
  template <class Add>
  static void each_pass_for_few(Add const& add) {
    add(&Step::predict_few, Awaits::neighbours);
    add(&Step::measure, Awaits::neighbours, true);
    add(&Step::correct_few, Awaits::own);
  }
};

}  // namespace bagnold
