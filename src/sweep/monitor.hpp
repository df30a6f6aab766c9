// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "src/sweep/results.hpp"
#include "src/sweep/sweep.hpp"
#include "src/sweep/sweep_folder.hpp"

namespace bagnold::sweep {

/// What a sweep tells whoever called it, and asks about ten times a second, all by the thread that
/// called it. Points are numbers of Sweep::points. As it is, nobody listens or stops the sweep.
class SweepMonitor {
 public:
  virtual ~SweepMonitor() = default;

  virtual bool stop_requested() { return false; }  ///< every point writes a checkpoint

  /// Points of this sweep are run from now on, until end().
  virtual void begin(Sweep const&) {}
  virtual void was_finished(std::size_t) {}     ///< before the sweep was called
  virtual void started(std::size_t) {}          ///< or goes on
  virtual void reached(std::size_t, double) {}  ///< share of the point's strain, in [0, 1]
  virtual void finished(std::size_t) {}
  virtual void stopped(std::size_t) {}  ///< because of stop_requested()
  virtual void failed(std::size_t) {}
  virtual void waited() {}  ///< about ten times a second
  virtual void end() {}

  /// The tables of what is done are in the folder.
  virtual void collected(Sweep const&, SweepFolder const&, Results const&) {}
};

}  // namespace bagnold::sweep
