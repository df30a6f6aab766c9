// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/analysis/kinds/kinds.hpp"
#include "src/cli/commands.hpp"
#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/plot.hpp"

namespace bagnold {
namespace {

using analysis::Rows;

constexpr std::size_t most_columns = 24;  ///< wider tables are only written

std::filesystem::path prefix_of(AnalyseOptions const& options) {
  if (!options.prefix.empty()) return options.prefix;
  bool const is_folder = std::filesystem::is_directory(options.sweep);
  return (is_folder ? options.sweep : options.sweep.parent_path()) / options.kind;
}

/// Numbers to four digits, all else as it is.
std::string shown(std::string const& text) {
  char* end = nullptr;
  double const value = std::strtod(text.c_str(), &end);
  if (text.empty()) return "-";
  return *end == '\0' && std::isfinite(value) ? fmt::format("{:.4g}", value) : text;
}

/// Columns as wide as their widest entry.
void print_rows(Rows const& rows) {
  std::vector<std::size_t> width;
  for (auto const& name : rows.columns) width.push_back(name.size());
  for (auto const& row : rows.rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      width[k] = std::max(width[k], shown(row[k]).size());
  auto const print = [&](std::vector<std::string> const& row, bool is_head) {
    for (std::size_t k = 0; k < row.size(); ++k)
      fmt::print("{:<{}}{}", is_head ? row[k] : shown(row[k]), width[k],
                 k + 1 < row.size() ? "  " : "\n");
  };
  print(rows.columns, true);
  for (auto const& row : rows.rows) print(row, false);
}

}  // namespace

std::string analyse_kinds() {
  std::string out = "Kinds of analysis (docs/analysis.md):\n";
  for (auto const& kind : analysis::kinds()) {
    out += fmt::format("  {:<18} {}\n", kind.name, kind.equation);
    if (!kind.source.empty()) out += fmt::format("  {:<18} {}\n", "", kind.source);
    out += fmt::format("  {:<18} {}\n", "", kind.options);
  }
  return out +
         "Written: PREFIX.csv (what was found), PREFIX.drawn.csv (what the picture shows), "
         "PREFIX.png.\nUnits: length d_s, time tau_e; stresses in m/tau_e^2.";
}

int analyse_command(AnalyseOptions const& options) {
  auto const& kind = analysis::kind_of(options.kind);
  auto const table = analysis::read_sweep_table(options.sweep);
  auto const report = kind.run(table, options.request);
  auto const prefix = prefix_of(options);
  auto const beside = [&](char const* ending) {
    auto path = prefix;
    return path += ending;
  };
  if (!prefix.parent_path().empty()) std::filesystem::create_directories(prefix.parent_path());
  io::replace_text(beside(".csv"), to_csv(report.results));
  io::replace_text(beside(".drawn.csv"), to_csv(report.drawn));
  if (!options.quiet) {
    fmt::print("{}: {}\n{}\n\n", kind.name, kind.equation, kind.source);
    if (report.results.columns.size() <= most_columns) print_rows(report.results);
    fmt::print("{} rows in {}\n", report.results.rows.size(), beside(".csv").string());
  }
  for (auto const& note : report.notes) warn(note);
  warn(draw_analysis(beside(".drawn.csv"), beside(".png")));
  return 0;
}

}  // namespace bagnold
