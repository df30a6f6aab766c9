// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "src/analysis/kinds/kinds.hpp"
#include "src/cli/analyse_options.hpp"
#include "src/cli/checked_sweep.hpp"
#include "src/cli/figure_file.hpp"
#include "src/cli/figure_stated.hpp"
#include "src/cli/options.hpp"
#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/plot.hpp"

namespace bagnold {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// "KIND --option value": the words of `bagnold analyse KIND SWEEP --option value`.
AnalyseOptions parse_words(std::string const& words, std::string const& figure) {
  auto const kind = words.substr(0, words.find(' '));
  CommandLine line;
  AnalyseOptions options;
  add_analyse_options(line.words(), options);
  try {
    line.parse_line(kind + " . " + words.substr(kind.size()));
  } catch (UnreadableWords const& error) {
    throw InputError(fmt::format("{}: analyse = \"{}\": {}", figure, words, error.what()));
  }
  return options;
}

/// Where the data sets of a figure lie.
struct DataFolder {
  fs::path folder;
  bool tables = false;  ///< NAME.csv and NAME.json instead of folders of sweeps

  fs::path sweep(std::string const& name) const { return folder / name; }
  fs::path measured(std::string const& name) const {
    return folder / (tables ? name + ".csv" : name);
  }
  /// What is drawn other than analyses: histograms, profiles, series.
  fs::path pictured(std::string const& name) const {
    return folder / (tables ? name + ".json" : name);
  }
};

using Names = std::vector<std::string>;

/// Makes one figure in a folder, from data that are there.
class FigureMaker {
 public:
  FigureMaker(Figure figure, fs::path const& out, DataFolder const& data)
      : figure_(std::move(figure)), data_(data), folder_(out / figure_.name) {
    fs::create_directories(folder_);
  }

  /// The recipe for the picture, with the tables that it names.
  fs::path write_recipe() {
    json recipe = figure_.layout;
    recipe["name"] = figure_.name;
    int number = 0;
    for (auto& panel : figure_.panels) {
      auto const stem = fmt::format("panel{}", ++number);
      auto const data = panel.at("data").get<Names>();
      panel["folder"] = json::array();
      for (auto const& name : data)
        panel["folder"].push_back(
            fs::absolute(data_.pictured(name)).lexically_proximate(fs::absolute(folder_)).string());
      if (panel.contains("analyse")) panel["drawn"] = write_drawn(stem, panel.at("analyse"), data);
      auto const others = panel.value("of", json::object());
      for (auto const& [name, words] : others.items())
        panel["of_drawn"][name] = write_drawn(stem + "_" + name, words, data);
    }
    recipe["panel"] = figure_.panels;
    auto const path = folder_ / "recipe.json";
    io::replace_text(path, recipe.dump(1) + "\n");
    return path;
  }

  std::vector<Comparison> compare_stated() {
    std::vector<Comparison> all;
    for (auto const& entry : figure_.stated) {
      auto const found =
          compare(entry, analyse(entry.at("analyse"), entry.at("data").get<Names>()).results);
      all.insert(all.end(), found.begin(), found.end());
    }
    if (!all.empty()) io::replace_text(folder_ / "stated.csv", to_csv(to_rows(all)));
    return all;
  }

 private:
  /// What an analysis finds, with what is to be said of it, once; nothing, with a word why, where
  /// it finds nothing.
  analysis::Report const& analyse(std::string const& words, Names const& data) {
    auto const [known, is_new] = reports_.try_emplace({words, data});
    if (!is_new) return known->second;
    auto const options = parse_words(words, figure_.name);
    auto const say = [&](std::string const& what) {
      if (said_.insert(what).second) warn(fmt::format("{}: {}: {}", figure_.name, words, what));
    };
    try {
      known->second = analysis::kind_of(options.kind).run(table_of(data), options.request);
    } catch (InputError const& error) {
      say(error.what());
    }
    for (auto const& note : known->second.notes) say(note);
    return known->second;
  }

  /// The tables of those data sets that are there.
  analysis::SweepTable const& table_of(Names const& data) {
    if (auto const known = tables_.find(data); known != tables_.end()) return known->second;
    std::vector<analysis::SweepTable> parts;
    for (auto const& name : data)
      if (auto const path = data_.measured(name); fs::exists(path))
        parts.push_back(analysis::read_sweep_table(path));
    if (parts.empty())
      throw InputError(fmt::format("{} is not there", data_.measured(data.front()).string()));
    return tables_.emplace(data, merge_tables(parts)).first->second;
  }

  std::string write_drawn(std::string const& stem, std::string const& words, Names const& data) {
    auto const& report = analyse(words, data);
    io::replace_text(folder_ / (stem + ".csv"), to_csv(report.results));
    io::replace_text(folder_ / (stem + ".drawn.csv"), to_csv(report.drawn));
    return stem + ".drawn.csv";
  }

  Figure figure_;
  DataFolder data_;
  fs::path folder_;
  std::map<Names, analysis::SweepTable> tables_;
  std::map<std::pair<std::string, Names>, analysis::Report> reports_;
  std::set<std::string> said_;  ///< each thing once
};

/// Runs the sweeps of a figure that are not done; their exit code.
int run_sweeps(FigureFile const& file, Figure const& figure, DataFolder const& data,
               FigureOptions const& options) {
  int status = 0;
  for (auto const& name : figure.data) {
    SweepOptions sweep;
    sweep.sweep_file = file.sweep(name);
    sweep.folder = data.sweep(name);
    sweep.jobs = options.jobs;
    sweep.quiet = options.quiet;
    int const done = run_sweep(read_checked_sweep(sweep.sweep_file, sweep.allow_unstable), sweep);
    if (done > 128) return done;
    status = std::max(status, done);
  }
  return status;
}

/// Throws InputError where a folder has the tables of no data set of a figure, and says which ones
/// it lacks.
void check_tables(Figure const& figure, DataFolder const& data) {
  std::vector<std::string> missing;
  for (auto const& name : figure.data)
    if (!fs::exists(data.measured(name)) && !fs::exists(data.pictured(name)))
      missing.push_back(data.measured(name).filename().string());
  if (missing.empty()) return;
  auto const said =
      fmt::format("{}: {} not in {}", figure.name, fmt::join(missing, ", "), data.folder.string());
  if (missing.size() == figure.data.size())
    throw InputError(said + "; without --data its sweeps are run");
  warn(said + ": drawn without");
}

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

/// Makes a figure of the papers: runs its sweeps where they are not done, draws it, and compares
/// with what the text of the paper states. Codes as of a sweep; 1 where there is no picture.
int figure_command(FigureOptions const& options) try {
  FigureFile const file(find_figure_file(options.figures));
  if (options.name.empty()) return list_figures(file);
  auto const figure = read_checked(file, options.name, options.quick);
  fs::path const out = options.folder.empty() ? fs::path("results/figures") : options.folder;
  DataFolder const data{options.data.empty() ? out / "data" : options.data, !options.data.empty()};
  int status = 0;
  if (data.tables)
    check_tables(figure, data);
  else
    status = run_sweeps(file, figure, data, options);
  if (status > 128) return status;
  FigureMaker maker(figure, out, data);
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
} catch (json::exception const& error) {  // of a key of another type, or one that is missing
  throw InputError(
      fmt::format("the file of figures: {} {}; see docs/figures.md", options.name, error.what()));
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
  command.option("--jobs", options->jobs, "runs at a time [default: cores]").between(1, 4096);
  command.flag("--quiet", options->quiet, "no progress and no table; errors are still shown");
  return {command, [options] { return figure_command(*options); }};
}

}  // namespace bagnold
