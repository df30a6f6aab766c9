// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/figures/figure_maker.hpp"

#include <fmt/format.h>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/messages.hpp"

namespace bagnold::analysis {

namespace fs = std::filesystem;
using nlohmann::json;

FigureMaker::FigureMaker(Figure figure, fs::path folder, DataFolder data, ReadWords read)
    : figure_(std::move(figure)),
      folder_(std::move(folder)),
      data_(std::move(data)),
      read_(std::move(read)) {
  fs::create_directories(folder_);
}

fs::path FigureMaker::write_recipe() {
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

std::vector<Comparison> FigureMaker::compare_stated() {
  std::vector<Comparison> all;
  for (auto const& entry : figure_.stated) {
    auto const found =
        compare(entry, report_of(entry.at("analyse"), entry.at("data").get<Names>()).results);
    all.insert(all.end(), found.begin(), found.end());
  }
  if (!all.empty()) io::replace_text(folder_ / "stated.csv", to_csv(to_rows(all)));
  return all;
}

/// Report of an analysis, worked out once. Where the analysis finds nothing, warns on stderr and
/// returns an empty report.
Report const& FigureMaker::report_of(std::string const& words, Names const& data) {
  auto const [known, is_new] = reports_.try_emplace({words, data});
  if (!is_new) return known->second;
  auto const asked = read_(words, figure_.name);
  auto const say = [&](std::string const& what) {
    if (said_.insert(what).second) warn(fmt::format("{}: {}: {}", figure_.name, words, what));
  };
  try {
    known->second = kind_of(asked.kind).run(table_of(data), asked.request);
  } catch (InputError const& error) {
    say(error.what());
  }
  for (auto const& note : known->second.notes) say(note);
  return known->second;
}

/// Joined tables of the data sets that exist.
SweepTable const& FigureMaker::table_of(Names const& data) {
  if (auto const known = tables_.find(data); known != tables_.end()) return known->second;
  std::vector<SweepTable> parts;
  for (auto const& name : data)
    if (auto const path = data_.measured(name); fs::exists(path))
      parts.push_back(read_sweep_table(path));
  if (parts.empty())
    throw InputError(fmt::format("{} is not there", data_.measured(data.front()).string()));
  return tables_.emplace(data, merge_tables(parts)).first->second;
}

std::string FigureMaker::write_drawn(std::string const& stem, std::string const& words,
                                     Names const& data) {
  auto const& report = report_of(words, data);
  io::replace_text(folder_ / (stem + ".csv"), to_csv(report.results));
  io::replace_text(folder_ / (stem + ".drawn.csv"), to_csv(report.drawn));
  return stem + ".drawn.csv";
}

}  // namespace bagnold::analysis
