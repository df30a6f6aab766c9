// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/analyse.hpp"
#include "src/analysis/figures/data_folder.hpp"
#include "src/analysis/figures/figure_file.hpp"
#include "src/analysis/figures/stated.hpp"

namespace bagnold::analysis {

/// Reads "KIND --option value", the words of `bagnold analyse KIND SWEEP --option value` that stand
/// in figure NAME (second argument). Throws InputError, naming the figure.
using ReadWords = std::function<KindRequest(std::string const& words, std::string const& figure)>;

/// Makes one figure in a folder from existing data: the tables and the recipe of its picture, and
/// the comparison with what the paper states. Remarks of the analyses go to stderr, each once.
class FigureMaker {
 public:
  /// Makes the folder.
  FigureMaker(Figure figure, std::filesystem::path folder, DataFolder data, ReadWords read);

  /// Writes recipe.json for draw_figure() (src/run/plot.hpp), with the tables that it names:
  /// panelN.csv and panelN.drawn.csv. Returns its path.
  std::filesystem::path write_recipe();

  /// Writes stated.csv where the paper states anything.
  std::vector<Comparison> compare_stated();

 private:
  using Names = std::vector<std::string>;

  Report const& report_of(std::string const& words, Names const& data);
  SweepTable const& table_of(Names const& data);
  std::string write_drawn(std::string const& stem, std::string const& words, Names const& data);

  Figure figure_;
  std::filesystem::path folder_;
  DataFolder data_;
  ReadWords read_;
  std::map<Names, SweepTable> tables_;
  std::map<std::pair<std::string, Names>, Report> reports_;
  std::set<std::string> said_;  ///< each thing once
};

}  // namespace bagnold::analysis
