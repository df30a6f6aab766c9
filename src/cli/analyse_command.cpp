// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "src/cli/analyse_options.hpp"
#include "src/cli/options.hpp"
#include "src/config/shell_word.hpp"
#include "src/run/plot.hpp"

namespace bagnold {
namespace {

using analysis::Rows;

constexpr std::size_t most_columns = 26;  ///< wider tables are only written

/// Numbers to four digits, other text unchanged.
std::string cell_text(std::string const& text) {
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
      width[k] = std::max(width[k], cell_text(row[k]).size());
  auto const print = [&](std::vector<std::string> const& row, bool is_head) {
    for (std::size_t k = 0; k < row.size(); ++k)
      fmt::print("{:<{}}{}", is_head ? row[k] : cell_text(row[k]), width[k],
                 k + 1 < row.size() ? "  " : "\n");
  };
  print(rows.columns, true);
  for (auto const& row : rows.rows) print(row, false);
}

void print(analysis::Analysis const& made) {
  auto const& rows = made.report.results;
  fmt::print("{}: {}\n{}\n\n", made.kind->name, made.kind->equation, made.kind->source);
  if (rows.columns.size() <= most_columns) print_rows(rows);
  fmt::print("{} rows in {}\n", rows.rows.size(), made.results.string());
}

/// Prints the commands that follow the results or remarks on them.
void say_commands(analysis::Analysis const& made, AnalyseOptions const& options) {
  auto const has = [](std::string const& text, char const* words) {
    return text.find(words) != std::string::npos;
  };
  bool points = false, strain = false;
  for (auto const& row : made.report.results.rows)
    for (auto const& text : row) points = points || has(text, "add points");
  for (auto const& note : made.report.notes) strain = strain || has(note, "longer runs");
  auto folder = std::filesystem::path(options.sweeps.front());
  if (!std::filesystem::is_directory(folder)) folder = folder.parent_path();
  if (!std::filesystem::exists(folder / "sweep.toml")) return;  // a table alone
  auto const name = shell_word(folder.string());
  auto const again = fmt::format("`bagnold sweep FILE --out {}`", name);
  if (points)
    say(fmt::format(
        "to add points, add values to the sweep's file (a copy: {}/sweep.toml): {} runs "
        "these alone; or make another sweep and name both, `bagnold analyse {} {} SWEEP2`",
        folder.string(), again, options.asked.kind, name));
  if (strain)
    say(fmt::format("for longer runs raise shear.strain in the sweep's file: {} goes on with them",
                    again));
}

int analyse_command(AnalyseOptions const& options) {
  auto made = analysis::analyse(
      std::vector<std::filesystem::path>(options.sweeps.begin(), options.sweeps.end()),
      options.asked, options.prefix);
  if (!options.quiet) print(made);
  for (auto const& note : made.report.notes) warn(note);
  say_commands(made, options);
  made.picture.replace_extension(options.format);
  if (!made.report.drawn.rows.empty()) warn(draw_plot(made.drawn, made.picture));
  return 0;
}

}  // namespace

Command add_analyse(Words program) {
  auto const options = std::make_shared<AnalyseOptions>();
  Words command = add_command(program, "analyse", "fits and phase boundaries from a sweep");
  add_analyse_options(command, *options);
  return {command, [options] { return analyse_command(*options); }};
}

}  // namespace bagnold
