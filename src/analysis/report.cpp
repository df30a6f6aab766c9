// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/report.hpp"

#include <fmt/format.h>

namespace bagnold::analysis {

Rows tabulate(std::vector<Outcome> const& outcomes, std::vector<std::string> const& parameters) {
  Rows out;
  if (!outcomes.empty())
    for (auto const& [key, value] : outcomes.front().labels) out.columns.push_back(key);
  for (auto const& name : parameters)
    out.columns.insert(out.columns.end(), {name, name + "_error", name + "_bootstrap"});
  out.columns.insert(out.columns.end(), {"chi2", "freedom", "points", "failure"});
  for (auto const& one : outcomes) {
    std::vector<std::string> row;
    for (auto const& [key, value] : one.labels) row.push_back(value);
    bool const found = one.failure.empty();
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      row.push_back(found ? cell(one.found.value[k]) : "");
      row.push_back(found ? cell(one.found.error[k]) : "");
      row.push_back(found ? cell(one.bootstrap[k]) : "");
    }
    row.push_back(cell(one.found.chi2));
    row.push_back(found ? fmt::format("{}", one.found.freedom) : "");
    row.push_back(found ? fmt::format("{}", one.found.points) : "");
    row.push_back(one.failure);
    out.rows.push_back(std::move(row));
  }
  return out;
}

void note_left_out(Report& report, SweepTable const& table, std::vector<Series> const& series) {
  if (auto const failed = count_failed(table))
    report.notes.push_back(
        fmt::format("{} of {} points have no result and are left out", failed, table.points));
  std::size_t left_out = 0, unweighted = 0;
  for (auto const& one : series) {
    left_out += one.left_out;
    unweighted += !one.points(0).weighted();
  }
  if (left_out)
    report.notes.push_back(
        fmt::format("{} data have no value or no error and are left out (a datum "
                    "is one or several seeds)",
                    left_out));
  if (unweighted)
    report.notes.push_back(
        fmt::format("{} of {} curves have no errors: their points weigh the same, "
                    "and errors of what is fitted come from the scatter",
                    unweighted, series.size()));
}

}  // namespace bagnold::analysis
