// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "src/engine/sampling.hpp"
#include "src/state/snapshot.hpp"

namespace bagnold {

/// One sheared system under one law, on some backend.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Columns of a configuration's sums.
  virtual int columns() const = 0;

  virtual std::int64_t step() const = 0;

  /// Steps on by at least `steps`, to where the engine can stop, but not beyond sampling.last_step;
  /// with sampling.whole only to where a longer run would stop too, which may be short of that.
  /// Evaluates configurations at the start of sampled steps and adds them to `windows`. How a run
  /// is cut into calls changes no bit. Throws NumericalError.
  virtual void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) = 0;

  virtual Snapshot snapshot() const = 0;

  /// Gives back what the next step can make anew, so that a snapshot or a state has room beside it.
  /// Changes no bit.
  virtual void give_back_scratch() {}

  /// The state with all disks taken into the box.
  virtual State state() const = 0;
};

}  // namespace bagnold
