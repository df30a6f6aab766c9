// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "src/sweep/results.hpp"
#include "src/sweep/sweep.hpp"
#include "src/sweep/sweep_folder.hpp"

namespace bagnold::sweep {

/// Interface from a sweep to its caller. The sweep reports progress and asks about ten times a
/// second, always from the calling thread. Points are indices of Sweep::points. The default does
/// nothing and never stops the sweep.
class SweepMonitor {
 public:
  virtual ~SweepMonitor() = default;

  virtual bool stop_requested() { return false; }  ///< every point writes a checkpoint

  /// Called when points of this sweep begin to run, until end().
  virtual void begin(Sweep const&) {}
  virtual void was_finished(std::size_t) {}     ///< before the sweep was called
  virtual void started(std::size_t) {}          ///< or continued
  virtual void reached(std::size_t, double) {}  ///< share of the point's strain, in [0, 1]
  virtual void finished(std::size_t) {}
  virtual void stopped(std::size_t) {}  ///< because of stop_requested()
  virtual void failed(std::size_t) {}
  virtual void waited() {}  ///< about ten times a second
  virtual void end() {}

  /// Called when the tables of finished points are in the folder.
  virtual void collected(Sweep const&, SweepFolder const&, Results const&) {}
};

}  // namespace bagnold::sweep
