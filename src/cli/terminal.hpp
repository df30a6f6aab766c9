// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "src/cli/progress.hpp"
#include "src/run/monitor.hpp"

namespace bagnold {

/// Shows a run to its user on stdout, unless quiet, and stops it on their signals.
class Terminal final : public RunMonitor {
 public:
  /// all: prints the whole table, not only the most used observables.
  Terminal(bool quiet, bool all) : quiet_(quiet), all_(all) {}

  bool stop_requested() override;
  bool checkpoint_requested() override;
  void status(std::string const& text) override;
  void part(double before, double share) override { part_ = {before, share}; }
  void begin(Scene const& scene, Plan const& plan, std::int64_t steps) override;
  void progress(std::int64_t steps) override { progress_->show(steps); }
  void end(std::int64_t steps) override { progress_->finish(steps); }

  /// Prints the table of results and, on stderr, reasons to doubt them.
  void finished(RunFolder const& folder, FinishedRun const& run,
                std::vector<Warning> const& suspect) override;

 private:
  bool quiet_, all_;
  Progress::Part part_;
  std::optional<Progress> progress_;
};

}  // namespace bagnold
