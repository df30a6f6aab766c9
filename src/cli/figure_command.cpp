// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "src/analysis/kinds/kinds.hpp"
#include "src/cli/analyse_options.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/figure_file.hpp"
#include "src/cli/figure_stated.hpp"
#include "src/cli/plot.hpp"
#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// "KIND --option value": the words of `bagnold analyse KIND SWEEP --option value`.
AnalyseOptions parse_words(std::string const& words, std::string const& figure) {
  auto const kind = words.substr(0, words.find(' '));
  CLI::App app;
  AnalyseOptions options;
  add_analyse_options(app, options);
  try {
    app.parse(kind + " . " + words.substr(kind.size()));
  } catch (CLI::ParseError const& error) {
    throw InputError(fmt::format("{}: analyse = \"{}\": {}", figure, words, error.what()));
  }
  return options;
}

/// Makes one figure in a folder, from sweeps that are done.
class FigureMaker {
 public:
  FigureMaker(Figure figure, fs::path const& out)
      : figure_(std::move(figure)), out_(out), folder_(out / figure_.name) {
    fs::create_directories(folder_);
  }

  /// The recipe for the picture, with the tables that it names.
  fs::path write_recipe() {
    json recipe = figure_.layout;
    recipe["name"] = figure_.name;
    int number = 0;
    for (auto& panel : figure_.panels) {
      auto const stem = fmt::format("panel{}", ++number);
      auto const data = panel.at("data").get<std::string>();
      panel["folder"] = "../data/" + data;
      if (panel.contains("analyse")) panel["drawn"] = write_drawn(stem, panel.at("analyse"), data);
      for (auto const& [name, words] : panel.value("of", json::object()).items())
        panel["of_drawn"][name] = write_drawn(stem + "_" + name, words, data);
    }
    recipe["panel"] = figure_.panels;
    auto const path = folder_ / "recipe.json";
    io::replace_text(path, recipe.dump(1) + "\n");
    return path;
  }

  std::vector<Comparison> compare_stated() const {
    std::vector<Comparison> all;
    for (auto const& entry : figure_.stated) {
      auto const found = compare(entry, analyse(entry.at("analyse"), entry.at("data")).results);
      all.insert(all.end(), found.begin(), found.end());
    }
    if (!all.empty()) io::replace_text(folder_ / "stated.csv", to_csv(to_rows(all)));
    return all;
  }

 private:
  /// What an analysis finds; nothing, with a word why, where it finds nothing.
  analysis::Report analyse(std::string const& words, std::string const& data) const {
    auto const options = parse_words(words, figure_.name);
    auto const table = analysis::read_sweep_table(out_ / "data" / data);
    try {
      return analysis::kind_of(options.kind).run(table, options.request);
    } catch (InputError const& error) {
      warn(fmt::format("{}: {}: {}", figure_.name, words, error.what()));
      return {};
    }
  }

  std::string write_drawn(std::string const& stem, std::string const& words,
                          std::string const& data) const {
    auto const report = analyse(words, data);
    io::replace_text(folder_ / (stem + ".csv"), to_csv(report.results));
    io::replace_text(folder_ / (stem + ".drawn.csv"), to_csv(report.drawn));
    return stem + ".drawn.csv";
  }

  Figure figure_;
  fs::path out_, folder_;
};

/// A figure whose analyses and sweep files are there, so that mistakes are told before anything
/// runs.
Figure read_checked(FigureFile const& file, std::string const& name, bool quick) {
  auto figure = file.read(name, quick);
  for (auto const* entries : {&figure.panels, &figure.stated})
    for (auto const& entry : *entries)
      if (entry.contains("analyse")) analysis::kind_of(parse_words(entry.at("analyse"), name).kind);
  for (auto const& data : figure.data)
    if (!fs::exists(file.sweep(data)))
      throw InputError(
          fmt::format("{}: data = \"{}\": there is no {}", name, data, file.sweep(data).string()));
  return figure;
}

int list_figures(FigureFile const& file) {
  for (auto const& name : file.names()) {
    auto const figure = read_checked(file, name, false);
    if (file.has_quick(name)) read_checked(file, name, true);
    fmt::print("{:<6} {:<7} {:>7} h  {}\n", name, file.has_quick(name) ? "--quick" : "",
               fmt::format("{:g}", figure.hours), figure.title);
  }
  return 0;
}

}  // namespace

int figure_command(FigureOptions const& options) {
  FigureFile const file(find_figure_file(options.figures));
  if (options.name.empty()) return list_figures(file);
  auto const figure = read_checked(file, options.name, options.quick);
  fs::path const out = options.folder.empty() ? fs::path("results/figures") : options.folder;
  int status = 0;
  for (auto const& data : figure.data) {
    SweepOptions sweep;
    sweep.sweep_file = file.sweep(data);
    sweep.folder = out / "data" / data;
    sweep.jobs = options.jobs;
    sweep.quiet = options.quiet;
    int const done = sweep_command(sweep);
    if (done > 128) return done;
    status = std::max(status, done);
  }
  FigureMaker maker(figure, out);
  auto const recipe = maker.write_recipe();
  auto const picture = out / (figure.name + (options.quick ? "-quick.png" : ".png"));
  auto const stated = maker.compare_stated();
  if (!options.quiet) {
    fmt::print("{}: {}\nThe paper: {}\n", figure.name, figure.title, figure.claims);
    if (!stated.empty()) fmt::print("\n{}", to_lines(stated));
  }
  auto const wrong = draw_figure(recipe, picture);
  warn(wrong);
  if (wrong.empty() && !options.quiet) fmt::print("\npicture in {}\n", picture.string());
  return std::max(status, wrong.empty() ? 0 : 1);
}

}  // namespace bagnold
