// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/analysis/kinds/kinds.hpp"
#include "src/analysis/quantity.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

/// A row for each datum: varied keys but the seed, how many seeds, every observable, and what else
/// is asked for. Biases have columns of their own, as in the table of the sweep.
Rows rows_of(SweepTable const& table, std::vector<Curve> const& curves,
             std::vector<std::string> const& asked, std::optional<double> phi_j) {
  Rows out;
  std::vector<std::string> keys;
  for (auto const& [key, column] : table.keys)
    if (key != "disks.seed") keys.push_back(key);
  out.columns = keys;
  out.columns.emplace_back("seeds");
  std::vector<std::string> names;
  for (auto const& [name, values] : table.observables) names.push_back(name);
  for (auto const& name : asked)
    if (!table.observables.contains(name) && !table.keys.contains(name)) names.push_back(name);
  std::vector<Quantity> quantities;
  for (auto const& name : names) {
    out.columns.insert(out.columns.end(), {name, name + "_error"});
    quantities.emplace_back(table, name, phi_j);
  }
  for (auto const& curve : curves)
    for (auto const& datum : curve.data) {
      if (datum.rows.empty()) continue;
      std::vector<std::string> row;
      for (auto const& key : keys) row.push_back(key_text(table, key, datum.rows.front()));
      row.push_back(fmt::format("{}", datum.rows.size()));
      for (auto const& quantity : quantities) {
        auto const merged = quantity.without_bias(datum.rows);
        row.push_back(cell(merged.mean));
        row.push_back(cell(merged.error));
      }
      out.rows.push_back(std::move(row));
    }
  return out;
}

}  // namespace

Report merged_table(SweepTable const& table, Request const& request) {
  Report report;
  auto along = running_key(request, request.x);
  if (request.x.empty() && request.along.empty() && !table.keys.contains(along))
    for (auto const& [key, column] : table.keys)
      if (key != "disks.seed" && !column.is_text()) along = key;
  auto const x = or_else(request.x, along), y = or_else(request.y, "p");
  auto const curves = curves_of(table, {along, request.by, {}, request.where});
  report.results = rows_of(table, curves, {x, y}, request.phi_j);
  note_left_out(report, table, {});
  Panel panel(report, x, y, covers_decades(x), y != "mu");
  Quantity const right(table, x, request.phi_j), up(table, y, request.phi_j);
  std::size_t pooled = 0, data = 0;
  for (auto const& curve : curves) {  // those without an error too: nothing is fitted
    std::vector<std::pair<Value, Value>> points;
    for (auto const& datum : curve.data) {
      auto const at = right.of(datum.rows), value = up.of(datum.rows);
      bool const wanted =
          !request.range || (at.mean >= request.range->first && at.mean <= request.range->second);
      if (wanted && std::isfinite(at.mean) && std::isfinite(value.mean))
        points.emplace_back(at, value);
    }
    if (request.first != 0 && request.first < points.size()) {
      std::ranges::stable_sort(points, {}, [](auto const& point) { return point.first.mean; });
      points.resize(request.first);
    }
    for (auto const& [at, value] : points) {
      ++data;
      pooled += value.pooled;
      panel.point("data", caption(curve.labels), at.mean, at.error, value.mean, value.error);
    }
  }
  note_errors(report, pooled, data, up.widened());
  return report;
}

}  // namespace bagnold::analysis
