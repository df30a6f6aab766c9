// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/replicas.hpp"

#include <cmath>

namespace bagnold::statistics {
namespace {

/// Table with one row for each replica: the sums of its windows from `first` on. Replicas without
/// any are left out.
Windows totals(std::vector<Windows const*> const& replicas, std::size_t first) {
  Windows table{replicas.front()->columns, {}, {}};
  for (Windows const* windows : replicas) {
    std::vector<double> sums(windows->columns, 0.0);
    double weight = 0.0;
    for (std::size_t w = first; w < windows->size(); ++w) {
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += windows->row(w)[k];
      weight += windows->weight[w];
    }
    if (weight > 0.0) table.push_back(sums, weight);
  }
  return table;
}

void add_error_of_scatter(Estimate& all, Jackknife& jackknife, std::size_t replicas) {
  double const error = jackknife.error(1);
  if (!std::isfinite(error)) {
    all.remark = "undefined without one of the replicas: run longer for an error";
    return;
  }
  all.error = error;
  all.blocks = replicas;
}

/// Error, blocks, rough and remark of the combined errors of the replicas.
Estimate combined(std::vector<Estimate> const& each, Windows const& total) {
  Estimate within;
  double squares = 0.0, weights = 0.0;
  for (std::size_t r = 0; r < each.size(); ++r) {
    if (!each[r].error) {
      Estimate none;
      none.remark = each[r].remark;
      return none;
    }
    squares += std::pow(total.weight[r] * *each[r].error, 2);
    weights += total.weight[r];
    within.blocks += each[r].blocks;
    if (!each[r].rough) continue;
    within.rough = true;
    within.remark = each[r].remark;
  }
  within.error = std::sqrt(squares) / weights;
  return within;
}

std::optional<double> mean_correlation(std::vector<Estimate> const& each) {
  double sum = 0.0;
  int known = 0;
  for (auto const& one : each)
    if (one.correlation) {
      sum += *one.correlation;
      ++known;
    }
  return known > 0 ? std::optional(sum / known) : std::nullopt;
}

}  // namespace

ReplicaEstimate estimate(std::vector<Windows const*> const& replicas, std::size_t first,
                         Function const& f) {
  ReplicaEstimate result;
  for (Windows const* windows : replicas) result.each.push_back(estimate(*windows, first, f));
  Estimate& all = result.all;
  if (replicas.size() == 1) {
    all = result.within = result.each.front();
    return result;
  }
  for (auto const& one : result.each) {
    all.samples += one.samples;
    all.independent += one.independent;
  }
  all.correlation = mean_correlation(result.each);
  Windows const total = totals(replicas, first);
  if (total.size() < replicas.size()) {
    all.remark = "no window was measured: run longer";
    return result;
  }
  Jackknife jackknife(total, 0, f);
  if (!std::isfinite(jackknife.value())) {
    all.remark = "undefined: the averages give no finite value";
    return result;
  }
  all.mean = jackknife.value();
  result.within = combined(result.each, total);
  if (replicas.size() >= fewest_replicas) {
    add_error_of_scatter(all, jackknife, replicas.size());
    return result;
  }
  all.error = result.within.error;
  all.blocks = result.within.blocks;
  all.rough = result.within.rough;
  all.remark = result.within.remark;
  return result;
}

std::string_view error_source(std::size_t replicas) {
  if (replicas == 1) return "blocks of windows";
  return replicas < fewest_replicas ? "blocks of windows in each replica, combined"
                                    : "jackknife over replicas";
}

}  // namespace bagnold::statistics
