// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "src/analysis/analyse.hpp"
#include "src/sweep/checked_sweep.hpp"
#include "src/sweep/run_sweep.hpp"

/// sweep_consumer SWEEP FOLDER PROGRAM: runs a sweep and analyses it, as library calls.
int main(int count, char** words) try {
  if (count != 4) return 2;
  bagnold::sweep::SweepOptions options;
  options.program = words[3];
  auto const sweep = bagnold::sweep::read_checked_sweep(words[1]);
  if (run(sweep, words[2], options) != bagnold::sweep::SweepEnd::done) return 1;
  auto const table = bagnold::analysis::analyse(words[2], {.kind = "table"}).report.results;
  return table.rows.size() == sweep.points.size() ? 0 : 1;
} catch (std::exception const& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
