// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/sequence/piece_results.hpp"

#include "src/config/piece_table.hpp"
#include "src/run/protocols/passes.hpp"

namespace bagnold {

namespace {

/// Windows of one piece that are measured: by pass, and one by one for a single pass.
struct Measured {
  Passes passes;
  statistics::Windows each;
};

std::vector<Measured> measured_windows(Run const& run) {
  auto const& pieces = *run.plan.pieces;
  double const discard = run.scene.shear.discard.value_or(0);
  std::vector<Measured> found(pieces.size());
  for (std::size_t r = 0; r < run.replicas.size(); ++r) {
    auto const& windows = run.replicas[r].measurement.windows;
    for (std::size_t w = 0; w < windows.size(); ++w) {
      std::int64_t const begin = run.plan.window_begin(static_cast<std::int64_t>(w));
      auto const [cycle, piece] = pieces.place(begin);
      std::int64_t const since = begin - cycle * pieces.cycle_steps() - pieces[piece].begin;
      auto const of_piece = static_cast<double>(pieces.steps_of(piece));
      bool const is_last = run.plan.window_end(static_cast<std::int64_t>(w)) - begin + since >=
                           pieces.steps_of(piece);
      if (static_cast<double>(since) < discard * of_piece && !is_last) continue;
      bool const stops = pieces[piece].rate == 0;
      auto const steps = run.plan.window_end(static_cast<std::int64_t>(w)) - begin;
      double const weight = stops ? static_cast<double>(steps) : windows.weight[w];
      std::vector<double> sums(windows.row(w).begin(), windows.row(w).end());
      for (auto& sum : sums) sum *= weight / windows.weight[w];
      found[piece].passes.add(pass_of(run, r, cycle), sums, weight);
      found[piece].each.columns = windows.columns;
      found[piece].each.push_back(sums, weight);
    }
  }
  return found;
}

}  // namespace

std::vector<PieceResult> piece_results(Run const& run) {
  auto const& pieces = *run.plan.pieces;
  auto const list = observables(run.scene, run.box_length);
  std::vector<PieceResult> results;
  auto const found = measured_windows(run);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    PieceResult result;
    auto const first = pieces[k].begin, last = first + pieces.steps_of(k);
    result.strain_rate = pieces[k].rate;
    result.begin_strain = pieces.strain(first);
    result.strain = pieces.strain(last) - result.begin_strain;
    result.begin_time = run.plan.time_step * static_cast<double>(first);
    result.time = run.plan.time_step * static_cast<double>(last - first);
    result.windows = found[k].passes.windows;
    result.observables = list;
    auto const passes = found[k].passes.table();
    bool const flows_once = passes.size() == 1 && pieces[k].rate != 0;
    for (auto const& one : list)
      result.estimates.push_back(passes.size() == 0 ? statistics::Estimate{}
                                 : flows_once ? statistics::estimate(found[k].each, 0, one.value)
                                              : estimate_of_passes(passes, one.value));
    results.push_back(std::move(result));
  }
  return results;
}

statistics::Samples piece_table(Run const& run) {
  auto const& pieces = *run.plan.pieces;
  statistics::Samples table{
      "pieces",
      "pieces of all cycles, those to come too: windows first_window .. end_window - 1",
      {"cycle", "piece", "strain_rate [1/tau_e]", "begin_strain", "end_strain",
       "begin_time [tau_e]", "end_time [tau_e]", "first_window", "end_window"},
      {}};
  double const start = run.replicas.front().initial_time;
  for (std::int64_t cycle = 0; cycle < pieces.cycles(); ++cycle)
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      auto const begin = cycle * pieces.cycle_steps() + pieces[k].begin;
      auto const end = begin + pieces.steps_of(k);
      auto const first = run.plan.row_of(begin).first;
      auto const after = end == pieces.steps() ? run.plan.windows : run.plan.row_of(end).first;
      table.rows.insert(table.rows.end(),
                        {static_cast<double>(cycle + 1), static_cast<double>(k + 1), pieces[k].rate,
                         pieces.strain(begin), pieces.strain(end),
                         start + run.plan.time_step * static_cast<double>(begin),
                         start + run.plan.time_step * static_cast<double>(end),
                         static_cast<double>(first), static_cast<double>(after)});
    }
  return table;
}

}  // namespace bagnold
