// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/oscillate/cycles.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/config/oscillation.hpp"
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

/// Columns: 1, and for each harmonic its strain and its rate over omega. Rows: windows.
Eigen::MatrixXd terms_of(Run const& run) {
  auto const motion = motion_of(run);
  auto const rows = static_cast<Eigen::Index>(motion.phase.size());
  double const omega = 2 * std::numbers::pi / oscillation_period(run.scene);
  double const amplitude = run.scene.shear.amplitude;
  Eigen::MatrixXd terms(rows, 1 + 2 * harmonics_of(run));
  for (Eigen::Index k = 0; k < rows; ++k) {
    auto const at = static_cast<std::size_t>(k);
    terms(k, 0) = 1;
    terms(k, 1) = motion.strain[at];
    terms(k, 2) = motion.rate[at] / omega;
    for (std::int64_t n = 2; n <= harmonics_of(run); ++n) {
      terms(k, 2 * n - 1) = amplitude * std::sin(static_cast<double>(n) * motion.phase[at]);
      terms(k, 2 * n) = amplitude * std::cos(static_cast<double>(n) * motion.phase[at]);
    }
  }
  return terms;
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
}

}  // namespace

Cycles cycles_of(Run const& run) {
  Cycles cycles;
  cycles.observables = observables(run.scene, run.box_length);
  auto const sigma = of_name(cycles.observables, "sigma").value;
  auto const solver = terms_of(run).colPivHouseholderQr();
  auto const windows_of_cycle = run.plan.pieces->size();
  for (auto const& replica : run.replicas) {
    auto const& windows = replica.measurement.windows;
    auto const harmonics = 2 * static_cast<std::size_t>(harmonics_of(run));
    statistics::Windows table{windows.columns + harmonics, {}, {}};
    for (auto first = static_cast<std::size_t>(run.plan.discarded_windows);
         first + windows_of_cycle <= windows.size(); first += windows_of_cycle) {
      std::vector<double> row(table.columns);
      Eigen::VectorXd stress(static_cast<Eigen::Index>(windows_of_cycle));
      double weight = 0;
      for (std::size_t k = 0; k < windows_of_cycle; ++k) {
        auto const sums = windows.row(first + k);
        for (std::size_t c = 0; c < sums.size(); ++c) row[c] += sums[c];
        weight += windows.weight[first + k];
        stress(static_cast<Eigen::Index>(k)) = sigma(windows.mean(first + k, first + k + 1));
      }
      Eigen::VectorXd const moduli = solver.solve(stress);
      for (std::size_t c = 0; c < harmonics; ++c)
        row[windows.columns + c] = weight * moduli(static_cast<Eigen::Index>(c) + 1);
      table.push_back(row, weight);
    }
    cycles.of.push_back(std::move(table));
  }
  add_moduli(cycles.observables, run.replicas.front().measurement.windows.columns,
             harmonics_of(run));
  return cycles;
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
