// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

#include "src/engine/sampling.hpp"
#include "src/state/snapshot.hpp"

namespace bagnold {

/// One sheared system under one law, on one backend.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Number of columns of a configuration's sums.
  virtual int columns() const = 0;

  virtual std::int64_t step() const = 0;

  /// Advances by at least `steps`, to where the engine can stop, but not beyond sampling.last_step.
  /// With sampling.whole it stops only where a longer run would stop too, which may be earlier.
  /// Evaluates configurations at the start of sampled steps and adds them to `windows`. The
  /// division of a run into calls changes no bit. Throws NumericalError.
  virtual void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) = 0;

  /// Begins a piece of a controlled run at the present step, at another strain rate, [1/tau_e], and
  /// in a box whose length and height are `scale` times those before: positions are mapped
  /// affinely, velocities and spins keep their excess over the mean flow.
  virtual void begin_piece(double /*strain_rate*/, double /*scale*/) {
    throw std::logic_error("this engine is in control of no pieces");  // Abilities::pieces
  }

  /// Strain of a controlled run since step 0.
  virtual double strain() const {
    throw std::logic_error("this engine is in control of no pieces");  // Abilities::pieces
  }

  /// False where the present engine goes without steps, from event to event.
  virtual bool has_step() const { return true; }

  /// Method of the ladder of scheme = "auto" (src/config/ladder.hpp), and another one from here on,
  /// where the ladder's grid allows it.
  virtual std::size_t method() const { return 0; }
  virtual void take_method(std::size_t /*method*/) {
    throw std::logic_error("this engine has one method");
  }

  virtual Snapshot snapshot() const = 0;

  /// Counters of the snapshot alone.
  virtual std::map<std::string, double> counters() const { return snapshot().counters; }

  /// Releases memory that the next step allocates again, to make room for a snapshot or a state.
  /// Changes no bit.
  virtual void give_back_scratch() {}

  /// State with all disks wrapped into the box.
  virtual State state() const = 0;
};

}  // namespace bagnold
