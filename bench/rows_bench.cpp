// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "bench/row_systems.hpp"
#include "bench/rows.hpp"
#include "bench/spent.hpp"

namespace bagnold::bench {

namespace {

/// "default": engine and scheme that a scene gets which names none.
constexpr std::array engines{"auto",         "default",       "reference",
                             "few-contacts", "many-contacts", "lookahead"};

/// Time is that of the CPU for one thread, of the wall for several.
void report(benchmark::State& run, RowSystems const& systems, bool threaded, Spent const& spent,
            Counts const& counts, Counts const& before) {
  double const seconds = threaded ? spent.wall : spent.cpu;
  auto const [pairs, prunings, builds, one_by_one, looking_ahead] = counts - before;
  double const strain = systems.strain_done();
  run.SetIterationTime(seconds);
  auto& counters = run.counters;
  counters["strain"] = systems.strain();
  counters["cpu_seconds"] = spent.cpu;
  counters["wall_seconds"] = spent.wall;
  counters["seconds_per_strain"] = seconds / strain;
  counters["disk_steps_per_second"] = systems.disk_steps() / seconds;
  counters["builds_per_strain"] = builds / strain;
  if (one_by_one + looking_ahead == 0) return;  // the reference
  double const share = looking_ahead / (one_by_one + looking_ahead);
  counters["prunings_per_strain"] = prunings / strain;
  counters["share_in_lookahead"] = share;
  if (one_by_one > 0)
    counters["pairs_per_disk_step"] = pairs / ((1 - share) * systems.disk_steps());
}

void row_bench(benchmark::State& run, Row const& row, std::string const& engine,
               RowOptions const& options) {
  try {
    for (auto _ : run) {
      RowSystems systems(row, engine, options);
      Counts const before = systems.counts();
      Spent const begin = spent_so_far();
      systems.run();
      Spent const spent = spent_so_far() - begin;
      report(run, systems, row.threads * row.side_by_side > 1, spent, systems.counts(), before);
    }
  } catch (std::exception const& error) {
    run.SkipWithError(error.what());
  }
}

}  // namespace

void register_rows(RowOptions const& options) {
  for (auto const& row : rows)
    for (std::string const engine : engines) {
      std::string name = std::string(row.state) + '/' + engine;
      if (row.threads > 1) name += "/threads:" + std::to_string(row.threads);
      if (row.side_by_side > 1) name += "/side_by_side:" + std::to_string(row.side_by_side);
      benchmark::RegisterBenchmark(name.c_str(), row_bench, row, engine, options)
          ->Iterations(1)
          ->UseManualTime()
          ->Unit(benchmark::kSecond);
    }
}

}  // namespace bagnold::bench
