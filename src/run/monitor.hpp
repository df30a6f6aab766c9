// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/run/run_folder.hpp"
#include "src/run/warnings/warning.hpp"

namespace bagnold {

/// How a call to run a scene ends; a failure is thrown.
enum class RunEnd { done, stopped };

/// What a run tells whoever called it, and asks about twenty times a second, all by the thread that
/// called it. Steps are those of all replicas together. As it is, nobody listens or stops the run.
class RunMonitor {
 public:
  virtual ~RunMonitor() = default;

  virtual bool stop_requested() { return false; }        ///< with a checkpoint
  virtual bool checkpoint_requested() { return false; }  ///< since this was last asked

  /// What the run does now, a line.
  virtual void status(std::string const&) {}

  /// A run, or a stage of a cascade, begins to step or goes on from some step.
  virtual void begin(Scene const&, Plan const&, std::int64_t) {}
  virtual void progress(std::int64_t) {}
  virtual void end(std::int64_t) {}

  /// All results are in the folder.
  virtual void finished(RunFolder const&, FinishedRun const&, std::vector<Warning> const&) {}
};

}  // namespace bagnold
