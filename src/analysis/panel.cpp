// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "src/analysis/csv.hpp"

namespace bagnold::analysis {
namespace {

constexpr auto phi_key = "disks.packing_fraction";

/// The one label that differs among the outcomes and is a number; phi before others.
std::string numeric_label(std::vector<Outcome> const& outcomes) {
  std::string best;
  if (outcomes.empty()) return best;
  for (std::size_t k = 0; k < outcomes.front().labels.size(); ++k) {
    std::set<std::string> values;
    bool numbers = true;
    for (auto const& one : outcomes) {
      values.insert(one.labels[k].second);
      numbers = numbers && number_in(one.labels[k].second);
    }
    auto const& key = outcomes.front().labels[k].first;
    if (numbers && values.size() > 1 && (best.empty() || key == phi_key)) best = key;
  }
  return best;
}

}  // namespace

std::vector<std::string> const drawn_columns{"panel",   "x_name", "y_name", "x_scale",
                                             "y_scale", "curve",  "what",   "x",
                                             "x_error", "y",      "y_error"};

Panel::Panel(Report& report, std::string x_name, std::string y_name, bool log_x, bool log_y)
    : report_(report) {
  report.drawn.columns = drawn_columns;
  std::set<std::string> before;
  for (auto const& row : report.drawn.rows) before.insert(row.front());
  head_ = {fmt::format("{}", before.size() + 1), std::move(x_name), std::move(y_name),
           log_x ? "log" : "linear", log_y ? "log" : "linear"};
}

void Panel::point(std::string const& what, std::string const& curve, double x, double x_error,
                  double y, double y_error) {
  auto row = head_;
  for (auto const& text : {curve, what, cell(x), cell(x_error), cell(y), cell(y_error)})
    row.push_back(text);
  report_.drawn.rows.push_back(std::move(row));
}

void Panel::data(std::string const& curve, Points const& points,
                 std::vector<double> const& x_error) {
  for (std::size_t i = 0; i < points.size(); ++i)
    point("data", curve, points.x[i], x_error.empty() ? unknown : x_error[i], points.y[i],
          points.weighted() ? points.error[i] : unknown);
}

void Panel::line(std::string const& curve, Line const& line) {
  for (std::size_t i = 0; i < line.x.size(); ++i)
    point("fit", curve, line.x[i], unknown, line.y[i], unknown);
}

std::string symbol(std::string const& name) {
  if (name == "disks.elasticity") return "Q";
  if (name == "disks.packing_fraction") return "phi";
  if (name == "shear.strain_rate") return "gammadot";
  if (name == "disks.count") return "N";
  return name;
}

std::string caption(std::vector<Label> const& labels, std::string const& skip) {
  std::string out;
  for (auto const& [key, value] : labels)
    if (key != skip) out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", symbol(key), value);
  return out;
}

void draw_against_label(Report& report, std::vector<Outcome> const& outcomes,
                        std::vector<DrawnParameter> const& parameters, std::string const& axis,
                        bool log_value) {
  auto const label = numeric_label(outcomes);
  if (label.empty()) return;
  bool const log_label = label != phi_key;
  bool const value_right = axis == "phi" || axis.starts_with("phi_");
  Panel panel = value_right ? Panel(report, axis, label, log_value, log_label)
                            : Panel(report, label, axis, log_label, log_value);
  using Place = std::pair<double, Outcome const*>;
  std::vector<Place> in_order;  // outcomes come in the order of the table's rows
  for (auto const& one : outcomes)
    in_order.emplace_back(*number_in(std::ranges::find(one.labels, label, &Label::first)->second),
                          &one);
  std::ranges::stable_sort(in_order, {}, &Place::first);
  for (auto const& [index, name] : parameters)
    for (auto const& [at, outcome] : in_order) {
      auto const& one = *outcome;
      if (!one.failure.empty() || !std::isfinite(one.found.value[index])) continue;
      double const value = one.found.value[index], error = one.found.error[index];
      auto const others = caption(one.labels, label);
      auto const curve = name.empty() || others.empty() ? name + others : name + ", " + others;
      if (value_right)
        panel.point("data", curve, value, error, at, unknown);
      else
        panel.point("data", curve, at, unknown, value, error);
    }
}

}  // namespace bagnold::analysis
