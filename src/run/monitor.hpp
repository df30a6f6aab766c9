// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/run/run_folder.hpp"
#include "src/run/warnings/warning.hpp"

namespace bagnold {

struct Scene;

/// End of a call to run a scene; failures are thrown.
enum class RunEnd { done, stopped };

/// Interface from a run to its caller. The run reports progress and asks about twenty times a
/// second, always from the calling thread. Steps count all replicas together. The default does
/// nothing and never stops the run.
class RunMonitor {
 public:
  virtual ~RunMonitor() = default;

  virtual bool stop_requested() { return false; }        ///< with a checkpoint
  virtual bool checkpoint_requested() { return false; }  ///< since this was last asked

  /// Present activity of the run, one line.
  virtual void status(std::string const&) {}

  /// What begins next, a stage of a cascade, has this share of all work, after `before` of it.
  virtual void part([[maybe_unused]] double before, [[maybe_unused]] double share) {}

  /// Called when a run, or a stage of a cascade, begins to step or continues from a step.
  virtual void begin(Scene const&, Plan const&, std::int64_t) {}
  virtual void progress(std::int64_t) {}
  virtual void end(std::int64_t) {}

  /// All results are in the folder.
  virtual void finished(RunFolder const&, FinishedRun const&, std::vector<Warning> const&) {}
};

}  // namespace bagnold
