// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "src/engine/simulation.hpp"

namespace bagnold {

/// Systems that share launches: all are stepped at once.
class Ensemble {
 public:
  virtual ~Ensemble() = default;

  virtual std::size_t systems() const = 0;
  virtual int columns() const = 0;
  virtual std::int64_t step(std::size_t system) const = 0;

  /// Steps all systems that have not got there on to step `end`, but for those that cannot go on.
  /// The sampling is that of all calls.
  virtual void advance(std::int64_t end, Sampling const& sampling) = 0;

  /// Adds what was measured of a system since the last call. Throws NumericalError where the system
  /// cannot go on.
  virtual void take_samples(std::size_t system, OpenWindows& windows) = 0;

  virtual Snapshot snapshot(std::size_t system) const = 0;
  virtual State state(std::size_t system) const = 0;
};

/// The systems of an ensemble, [S], as simulations of their own. The first that is told to advance
/// takes all others along, which only hand out what was measured when they are told the same: so
/// they are to be advanced in turn, as run_measured does. They report no contacts.
std::vector<std::unique_ptr<Simulation>> members_of(std::shared_ptr<Ensemble> const& ensemble);

}  // namespace bagnold
