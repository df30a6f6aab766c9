// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/analysis/panel.hpp"

namespace bagnold::analysis {

Rows tabulate(std::vector<Outcome> const& outcomes, std::vector<std::string> const& parameters) {
  Rows out;
  if (!outcomes.empty())
    for (auto const& [key, value] : outcomes.front().labels) out.columns.push_back(key);
  for (auto const& name : parameters)
    out.columns.insert(out.columns.end(), {name, name + "_error", name + "_bootstrap"});
  out.columns.insert(out.columns.end(),
                     {"chi2", "freedom", "points", "misfit", "widened", "failure"});
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
    row.push_back(found && one.found.misfit > 0.0 ? cell(one.found.misfit) : "");
    row.push_back(found && one.found.widened > 1.0 ? cell(one.found.widened) : "");
    row.push_back(one.failure);
    out.rows.push_back(std::move(row));
  }
  return out;
}

void note_errors(Report& report, std::size_t pooled, std::size_t data, double widened) {
  constexpr double worth_a_word = 1.1;
  if (pooled != 0)
    report.notes.push_back(
        fmt::format("{} of {} data have a run without an error of its own, too short for it: it "
                    "weighs by the relative error of the others; longer runs would tell",
                    pooled, data));
  if (widened > worth_a_word)
    report.notes.push_back(
        fmt::format("seeds scatter {:.2g} times as much as their errors tell: errors are widened "
                    "by that",
                    widened));
}

void note_fits(Report& report, std::vector<Outcome> const& outcomes,
               std::vector<std::string> const& parameters) {
  std::size_t found = 0, poor = 0;
  double misfit = 0.0;
  Outcome const* worst = nullptr;
  auto const excess = [](Outcome const& one) {
    return one.found.chi2 / static_cast<double>(one.found.freedom);
  };
  for (auto const& one : outcomes) {
    if (!one.failure.empty()) continue;
    ++found;
    if (!beyond_chance(one.found)) continue;
    misfit = std::max(misfit, one.found.misfit);
    ++poor;
    if (!worst || excess(one) > excess(*worst)) worst = &one;
  }
  auto const named = [](Outcome const& one) {
    auto const name = caption(one.labels);
    return name.empty() ? name : ", " + name;
  };
  if (worst)
    report.notes.push_back(fmt::format(
        "chi2 is beyond chance in {} of {} fits (at worst {:.3g} for {} degrees of "
        "freedom{}): the law is not exact{}, or errors are too small; errors of what is "
        "fitted allow for it",
        poor, found, worst->found.chi2, worst->found.freedom, named(*worst),
        misfit > 0.0 ? fmt::format(" (off by {:.2g}%)", 100.0 * misfit) : ""));
  double widest = 1.0;
  for (auto const& one : outcomes) {
    if (!one.failure.empty()) continue;
    if (one.found.misfit == 0.0 && beyond_chance(one.found))
      widest = std::max(widest, one.found.widened);
    if (one.found.alike)
      report.notes.push_back(fmt::format(
          "the law that the places come from is not exact: they weigh alike in logarithms, errors "
          "come from their scatter, {:.2g}%{}; --weigh errors weighs by those of the places",
          100.0 * one.found.misfit, named(one)));
  }
  if (widest > 1.0)
    report.notes.push_back(fmt::format(
        "errors of what is fitted are widened, by up to {:.2g}, (chi2/freedom)^(1/2) with "
        "Student's factor: column widened",
        widest));
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    std::string list;
    for (auto const& one : outcomes)
      if (one.failure.empty() && one.found.error[k] > std::abs(one.found.value[k]))
        list += fmt::format("{}{:.3g} +- {:.2g}{}", list.empty() ? "" : "; ", one.found.value[k],
                            one.found.error[k], named(one));
    if (!list.empty())
      report.notes.push_back(fmt::format(
          "{}: the error exceeds the value ({}): the points do not tell it", parameters[k], list));
  }
}

void note_left_out(Report& report, SweepTable const& table, std::vector<Series> const& series) {
  if (auto note = table.left_out(); !note.empty()) report.notes.push_back(std::move(note));
  if (auto const failed = count_failed(table) - table.hardly_met)
    report.notes.push_back(
        fmt::format("{} of {} points have no result and are left out", failed, table.points));
  std::size_t left_out = 0, unweighted = 0, pooled = 0, data = 0;
  double widened = 1.0;
  for (auto const& one : series) {
    auto const points = one.points(0);
    left_out += one.left_out;
    unweighted += !points.weighted();
    pooled += one.pooled;
    data += points.size();
    widened = std::max(widened, one.widened);
  }
  if (left_out)
    report.notes.push_back(fmt::format(
        "{} data have no value and are left out (a datum is one or several seeds)", left_out));
  note_errors(report, pooled, data, widened);
  if (unweighted)
    report.notes.push_back(
        fmt::format("{} of {} curves have no errors: their points weigh the same, "
                    "and errors of what is fitted come from the scatter",
                    unweighted, series.size()));
}

}  // namespace bagnold::analysis
