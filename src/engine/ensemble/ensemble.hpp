// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "src/engine/simulation.hpp"

namespace bagnold {

/// Systems that share launches: all are stepped at the same time.
class Ensemble {
 public:
  virtual ~Ensemble() = default;

  virtual std::size_t systems() const = 0;
  virtual int columns() const = 0;
  virtual std::int64_t step(std::size_t system) const = 0;

  /// Steps all systems that are not there yet to step `end`, except those that cannot continue. The
  /// sampling is the same in all calls.
  virtual void advance(std::int64_t end, Sampling const& sampling) = 0;

  /// Adds the samples of a system since the last call. Throws NumericalError if the system cannot
  /// continue.
  virtual void take_samples(std::size_t system, OpenWindows& windows) = 0;

  virtual Snapshot snapshot(std::size_t system) const = 0;
  virtual State state(std::size_t system) const = 0;
};

/// Systems of an ensemble, [S], as simulations of their own. The first that is told to advance
/// steps all others too, which only return their samples when they are told the same. They are
/// therefore to be advanced in turn, as run_measured does. They report no contacts.
std::vector<std::unique_ptr<Simulation>> members_of(std::shared_ptr<Ensemble> const& ensemble);

}  // namespace bagnold
