// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/figures/stated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "src/analysis/panel.hpp"

namespace bagnold::analysis {
namespace {

using nlohmann::json;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A row of a table by the names of its columns.
class Row {
 public:
  Row(Rows const& table, std::vector<std::string> const& cells) : table_(table), cells_(cells) {}

  std::optional<std::string> text(std::string const& column) const {
    auto const found = std::ranges::find(table_.columns, column);
    if (found == table_.columns.end()) return std::nullopt;
    return cells_[static_cast<std::size_t>(found - table_.columns.begin())];
  }

  /// Number of a column; NaN if there is none.
  double number(std::string const& column) const {
    auto const cell = text(column).value_or("");
    char* end = nullptr;
    double const value = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end != '\0' ? none : value;
  }

 private:
  Rows const& table_;
  std::vector<std::string> const& cells_;
};

bool agrees(Row const& row, std::string const& column, json const& value) {
  if (value.is_number()) {
    double const wanted = value.get<double>();
    return std::abs(row.number(column) - wanted) <= 1e-9 * std::abs(wanted);
  }
  return row.text(column) == value.get<std::string>();
}

std::string with_error(double value, double error) {
  return std::isfinite(error) ? fmt::format("{:.4g} +- {:.1g}", value, error)
                              : fmt::format("{:.4g}", value);
}

/// Text such as ", phi = 0.7": scene keys that distinguish the chosen rows.
std::string differences(Rows const& table, std::vector<std::size_t> const& chosen,
                        std::size_t row) {
  std::string out;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    auto const cell = [&](std::size_t k) -> std::string const& { return table.rows[k][column]; };
    bool const is_key = table.columns[column].find('.') != std::string::npos;
    if (is_key && std::ranges::any_of(chosen, [&](auto k) { return cell(k) != cell(row); }))
      out += fmt::format(", {} = {}", symbol(table.columns[column]), cell(row));
  }
  return out;
}

/// A row that did not fail has left the column out on purpose: the data do not reach it.
std::string missing(Row const& row) { return row.text("failure") == "" ? "not told" : "not found"; }

Comparison compared(json const& entry, Row const& row) {
  auto const column = entry.at("column").get<std::string>();
  auto const& stated = entry.at("stated");
  double const ours = row.number(column), own = row.number(column + "_error");
  double const given = entry.value("error", none);
  bool const is_range = stated.is_array();
  double const low = is_range ? stated.at(0).get<double>() : stated.get<double>();
  double const high = is_range ? stated.at(1).get<double>() : low;
  double const off = ours - std::clamp(ours, low, high);
  double const error = std::isfinite(given) ? std::hypot(own, given) : own;
  Comparison out{entry.at("what"),
                 entry.at("source"),
                 is_range ? fmt::format("{:g} to {:g}", low, high) : with_error(low, given),
                 std::isfinite(ours) ? with_error(ours, own) : missing(row),
                 "-",
                 ""};
  auto const about = entry.value("about", json(false));
  bool const roughly = about != json(false);
  double const rounding = about.is_number() ? about.get<double>() : 0;
  if (roughly) out.stated = "about " + out.stated;
  if (!std::isfinite(ours)) return out;
  bool const wide = is_range && off == 0 && own > (high - low) / 2;
  double const beyond = std::max(0.0, std::abs(off) - rounding);
  double const errors = beyond == 0 ? 0 : beyond / (roughly ? own : error);
  out.agrees = wide ? "untold" : errors <= 2 ? "yes" : "no";
  if (roughly) {
    out.deviation = fmt::format("{:+.0f}%", 100 * off / std::abs(low));
    if (off != 0 && std::isfinite(off / own))
      out.deviation += fmt::format(" ({:+.1f} of our errors)", off / own);
  } else if (off == 0 && is_range) {
    out.deviation = wide ? "inside, our error is wider" : "inside";
  } else if (std::isfinite(off / error)) {
    out.deviation = fmt::format("{:+.1f} standard errors", off / error);
  }
  return out;
}

}  // namespace

std::vector<Comparison> compare(json const& entry, Rows const& results) {
  auto const conditions = entry.value("row", json::object());
  auto const items = conditions.items();
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < results.rows.size(); ++k)
    if (std::all_of(items.begin(), items.end(), [&](auto const& one) {
          return agrees(Row(results, results.rows[k]), one.key(), one.value());
        }))
      chosen.push_back(k);
  std::vector<Comparison> out;
  if (chosen.empty()) out.push_back(compared(entry, Row({}, {})));
  for (auto const k : chosen) {
    out.push_back(compared(entry, Row(results, results.rows[k])));
    out.back().what += differences(results, chosen, k);
  }
  return out;
}

std::string to_lines(std::vector<Comparison> const& list) {
  std::size_t width[4] = {0, 10, 4, 9};
  for (auto const& one : list) {
    std::size_t k = 0;
    for (auto const* text : {&one.what, &one.stated, &one.ours, &one.deviation})
      width[k] = std::max(width[k], text->size()), ++k;
  }
  auto const line = [&](Comparison const& c) {
    return fmt::format("{:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", c.what, width[0], c.stated, width[1],
                       c.ours, width[2], c.deviation, width[3], c.source);
  };
  std::string out = line({"", "", "the papers", "ours", "deviation", ""});
  for (auto const& one : list) out += line(one);
  return out;
}

Rows to_rows(std::vector<Comparison> const& list) {
  Rows rows{{"what", "stated", "ours", "deviation", "agrees", "source"}, {}};
  for (auto const& c : list)
    rows.rows.push_back({c.what, c.stated, c.ours, c.deviation, c.agrees, c.source});
  return rows;
}

}  // namespace bagnold::analysis
