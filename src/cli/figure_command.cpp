// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "src/analysis/figures/prepare_figure.hpp"
#include "src/cli/analyse_options.hpp"
#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/sweep_terminal.hpp"
#include "src/config/errors.hpp"
#include "src/run/plot.hpp"

namespace bagnold {

namespace {

/// "KIND --option value": the words of `bagnold analyse KIND SWEEP --option value`.
analysis::KindRequest parse_words(std::string const& words, std::string const& figure) {
  auto const kind = words.substr(0, words.find(' '));
  CommandLine line;
  AnalyseOptions options;
  add_analyse_options(line.words(), options);
  try {
    line.parse_line(kind + " . " + words.substr(kind.size()));
  } catch (UnreadableWords const& error) {
    throw InputError(fmt::format("{}: analyse = \"{}\": {}", figure, words, error.what()));
  }
  return options.asked;
}

void print_in_list(analysis::Figure const& figure, bool has_quick) {
  fmt::print("{:<6} {:<7} {:>7} h  {}\n", figure.name, has_quick ? "--quick" : "",
             fmt::format("{:g}", figure.hours), figure.title);
}

void print(analysis::PreparedFigure const& made) {
  auto const& figure = made.figure;
  fmt::print("{}: {}\nThe paper: {}\n", figure.name, figure.title, figure.claims);
  if (!figure.remark.empty()) fmt::print("Ours: {}\n", figure.remark);
  if (!made.stated.empty()) fmt::print("\n{}", to_lines(made.stated));
}

/// Returns the codes of a sweep; 1 if there is no picture.
int figure_command(FigureOptions const& options) {
  auto const file = analysis::find_figure_file(options.figures);
  if (options.name.empty()) {
    analysis::list_figures(file, parse_words, print_in_list);
    return done;
  }
  if (options.data.empty()) catch_signals();
  SweepTerminal terminal(options.quiet);
  auto const out =
      options.folder.empty() ? std::filesystem::path("results/figures") : options.folder;
  auto made =
      analysis::prepare_figure(file, {options.name, options.quick, out, options.data, parse_words,
                                      sweep_options({}, options.jobs, terminal)});
  if (made.sweeps == sweep::SweepEnd::stopped) return exit_code_of(made.sweeps);
  if (!options.quiet) print(made);
  made.picture.replace_extension(options.format);
  auto const wrong = draw_figure(made.recipe, made.picture);
  warn(wrong);
  if (!wrong.empty()) return points_failed;
  if (!options.quiet) fmt::print("\npicture in {}\n", made.picture.string());
  return exit_code_of(made.sweeps);
}

}  // namespace

Command add_figure(Words program) {
  auto const options = std::make_shared<FigureOptions>();
  Words command = add_command(program, "figure",
                              "run and draw a figure of the papers; without a name: list them");
  command.option("NAME", options->name, "P2-15: Fig. 15 of P2 (docs/figures.md)");
  command.flag("--quick", options->quick, "a small version, of minutes, where there is one");
  command.option("--out", options->folder,
                 "folder for pictures, and for data that figures share [results/figures]");
  command.option("--data", options->data,
                 "draw from the tables in this folder, docs/data/figures; run nothing");
  command.option("--figures", options->figures, "file of figures [inputs/figures/figures.toml]");
  add_picture_format(command, options->format);
  command.option("--jobs", options->jobs, "runs at a time [default: cores]").between(1, 4096);
  command.flag("--quiet", options->quiet, "no progress and no table; errors are still shown");
  return {command, [options] { return figure_command(*options); }};
}

}  // namespace bagnold
