// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/terminal.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "src/cli/signals.hpp"
#include "src/cli/standard_streams.hpp"
#include "src/cli/table.hpp"
#include "src/run/messages.hpp"

namespace bagnold {

bool Terminal::stop_requested() { return stop_signal() != 0; }

bool Terminal::checkpoint_requested() { return bagnold::checkpoint_requested(); }

void Terminal::status(std::string const& text) {
  if (!quiet_) put(text + "\n");
}

void Terminal::begin(Scene const& scene, Plan const& plan, std::int64_t steps) {
  progress_.emplace(scene, plan, steps, quiet_);
}

void Terminal::finished(RunFolder const& folder, FinishedRun const& run,
                        std::vector<Warning> const& suspect) {
  if (quiet_) return;
  print_table(run.run, run.found);
  fmt::print("\nresults in {}\n", folder.path().string());
  std::fflush(stdout);  // before stderr
  for (auto const& warning : suspect) warn(text_of(warning));
}

}  // namespace bagnold
