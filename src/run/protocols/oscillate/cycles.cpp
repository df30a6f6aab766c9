// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/oscillate/cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "src/config/oscillation.hpp"
#include "src/run/protocols/oscillate/cycle_fit.hpp"
#include "src/run/protocols/passes.hpp"

namespace bagnold {

namespace {

constexpr std::int64_t most_harmonics = 5;

/// Strain and strain rate of the windows of a cycle, and their phase.
struct Motion {
  std::vector<double> strain, rate, phase;  ///< [K]
};

Motion motion_of(Run const& run) {
  auto const& pieces = *run.plan.pieces;
  Motion motion;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    std::int64_t const samples = (pieces.steps_of(k) + run.plan.every - 1) / run.plan.every;
    double const time =
        run.plan.time_step * static_cast<double>((samples - 1) * run.plan.every) / 2;
    double const begin = run.plan.time_step * static_cast<double>(pieces[k].begin);
    motion.strain.push_back(pieces[k].strain.rounded() + pieces[k].rate * time);
    motion.rate.push_back(pieces[k].rate);
    motion.phase.push_back(2 * std::numbers::pi * (begin + time) / oscillation_period(run.scene));
  }
  return motion;
}

std::int64_t harmonics_of(Run const& run) {
  return std::min<std::int64_t>(most_harmonics, run.scene.shear.cycle_pieces / 2 - 1);
}

/// For each window: 1, for each harmonic its strain and its rate over omega, and the time in cycles
/// from the middle of the cycle, for a drift.
std::vector<std::vector<double>> terms_of(Run const& run) {
  auto const motion = motion_of(run);
  double const omega = 2 * std::numbers::pi / oscillation_period(run.scene);
  double const amplitude = run.scene.shear.amplitude;
  std::vector<std::vector<double>> terms;
  for (std::size_t k = 0; k < motion.phase.size(); ++k) {
    auto& row = terms.emplace_back(std::vector{1.0, motion.strain[k], motion.rate[k] / omega});
    for (std::int64_t n = 2; n <= harmonics_of(run); ++n) {
      row.push_back(amplitude * std::sin(static_cast<double>(n) * motion.phase[k]));
      row.push_back(amplitude * std::cos(static_cast<double>(n) * motion.phase[k]));
    }
    row.push_back(motion.phase[k] / (2 * std::numbers::pi) - 0.5);
  }
  return terms;
}

/// Drift over a cycle: the mean difference of windows a period apart, of which one lies about its
/// beginning and the other about its end. So it is that of this cycle, and what the strain does
/// drops out. None of a cycle alone.
std::optional<double> drift_of(std::span<double const> sigma, std::size_t cycle,
                               std::size_t windows_of_cycle) {
  auto const begin = cycle * windows_of_cycle, near = windows_of_cycle / 4;
  auto const first = begin - std::min(near, begin);
  auto const last = std::min(begin + near, sigma.size() - windows_of_cycle);
  if (first == last) return {};
  double sum = 0;
  for (auto w = first; w < last; ++w) sum += sigma[w + windows_of_cycle] - sigma[w];
  return sum / static_cast<double>(last - first);
}

Observable const& of_name(std::vector<Observable> const& list, std::string_view name) {
  return *std::ranges::find(list, name, &Observable::name);
}

constexpr std::string_view storage[] = {"G_storage", "G_storage_2", "G_storage_3", "G_storage_4",
                                        "G_storage_5"};
constexpr std::string_view loss[] = {"G_loss", "G_loss_2", "G_loss_3", "G_loss_4", "G_loss_5"};

void add_moduli(std::vector<Observable>& list, std::size_t first, std::int64_t harmonics) {
  for (std::size_t n = 0; n < static_cast<std::size_t>(harmonics); ++n) {
    auto const column = [at = first + 2 * n](std::size_t k) {
      return [at, k](std::span<double const> a) { return a[at + k]; };
    };
    list.push_back({storage[n], "m/tau_e^2",
                    n == 0 ? "storage modulus G'" : "part of sigma/gamma_0 in sin(n omega t)",
                    column(0)});
    list.push_back({loss[n], "m/tau_e^2",
                    n == 0 ? "loss modulus G''" : "part of sigma/gamma_0 in cos(n omega t)",
                    column(1)});
  }
  list.push_back({"sigma_drift", "m/tau_e^2", "change of sigma in a cycle that does not come back",
                  [at = first + 2 * static_cast<std::size_t>(harmonics)](
                      std::span<double const> a) { return a[at]; }});
}

}  // namespace

Cycles cycles_of(Run const& run) {
  Cycles cycles;
  cycles.observables = observables(run.scene, run.box_length);
  auto const sigma = of_name(cycles.observables, "sigma").value;
  CycleFit const fit(terms_of(run));
  auto const harmonics = harmonics_of(run);
  auto const windows_of_cycle = run.plan.pieces->size();
  cycles.discarded = static_cast<std::size_t>(run.plan.discarded_windows) / windows_of_cycle;
  for (auto const& replica : run.replicas) {
    auto const& windows = replica.measurement.windows;
    auto const count = windows.size() / windows_of_cycle;
    std::vector<double> stress(count * windows_of_cycle);
    for (std::size_t w = 0; w < stress.size(); ++w) stress[w] = sigma(windows.mean(w, w + 1));
    statistics::Windows table{
        windows.columns + 2 * static_cast<std::size_t>(harmonics) + 1, {}, {}};
    for (std::size_t cycle = 0; cycle < count; ++cycle) {
      std::vector<double> row(table.columns);
      double weight = 0;
      for (std::size_t w = cycle * windows_of_cycle; w < (cycle + 1) * windows_of_cycle; ++w) {
        auto const sums = windows.row(w);
        for (std::size_t c = 0; c < sums.size(); ++c) row[c] += sums[c];
        weight += windows.weight[w];
      }
      auto const found = fit(std::span(stress).subspan(cycle * windows_of_cycle, windows_of_cycle),
                             drift_of(stress, cycle, windows_of_cycle));
      for (std::size_t c = 0; c < found.size(); ++c) row[windows.columns + c] = weight * found[c];
      table.push_back(row, weight);
    }
    cycles.of.push_back(std::move(table));
  }
  cycles.averages = cycles.observables.size();
  add_moduli(cycles.observables, run.replicas.front().measurement.windows.columns, harmonics);
  return cycles;
}

statistics::Samples cycle_table(Run const& run) {
  auto const cycles = cycles_of(run);
  statistics::Samples table{"cycles",
                            "moduli of each cycle; measured: 1 if it is in the averages, else 0",
                            {"seed", "cycle", "measured"},
                            {}};
  auto const fitted = std::span(cycles.observables).subspan(cycles.averages);
  for (auto const& one : fitted)
    table.columns.push_back(fmt::format("{} [{}]", one.name, one.unit));
  for (std::size_t r = 0; r < cycles.of.size(); ++r)
    for (std::size_t cycle = 0; cycle < cycles.of[r].size(); ++cycle) {
      table.rows.insert(table.rows.end(),
                        {static_cast<double>(run.scene.disks.seed) + static_cast<double>(r),
                         static_cast<double>(cycle + 1), cycle < cycles.discarded ? 0.0 : 1.0});
      for (auto const& one : fitted)
        table.rows.push_back(one.value(cycles.of[r].mean(cycle, cycle + 1)));
    }
  return table;
}

Waveform waveform_of(Run const& run) {
  auto const list = observables(run.scene, run.box_length);
  auto const count = run.plan.pieces->size();
  std::vector<Passes> passes(count);
  for (std::size_t r = 0; r < run.replicas.size(); ++r) {
    auto const& windows = run.replicas[r].measurement.windows;
    for (auto w = static_cast<std::size_t>(run.plan.discarded_windows); w < windows.size(); ++w)
      passes[w % count].add(pass_of(run, r, static_cast<std::int64_t>(w / count)), windows.row(w),
                            windows.weight[w]);
  }
  auto const motion = motion_of(run);
  Waveform wave{motion.strain, motion.rate, {}, {}};
  for (auto const& of_phase : passes) {
    auto const table = of_phase.table();
    auto const of = [&](std::string_view name) {
      return table.size() == 0 ? statistics::Estimate{}
                               : estimate_of_passes(table, of_name(list, name).value);
    };
    wave.sigma.push_back(of("sigma"));
    wave.pressure.push_back(of("p"));
  }
  return wave;
}

}  // namespace bagnold
