// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bagnold::analysis {

/// A figure of the papers from inputs/figures/figures.toml, with its values filled in.
struct Figure {
  std::string name;               ///< "P2-15"
  std::string title;              ///< what it shows
  std::string claims;             ///< what the paper says of it
  std::string remark;             ///< what ours shows beside that; may be empty
  double hours = 0;               ///< of one core, for all its data
  std::vector<std::string> data;  ///< its sweeps: files DATA.toml beside the file of figures
  nlohmann::json panels;          ///< as python/bagnold/plots/figure_page.py takes them
  nlohmann::json stated;          ///< numbers that the paper states, see stated.hpp
  nlohmann::json layout;          ///< all other keys, for python/bagnold/plots/figure_page.py
};

/// All figures of a file, by name.
class FigureFile {
 public:
  /// Throws InputError with line and column.
  explicit FigureFile(std::filesystem::path const& file);

  /// In the order of their papers and numbers.
  std::vector<std::string> names() const;
  bool has_quick(std::string const& name) const;

  /// quick: its small version. Throws InputError for an unknown name (with the nearest one), one
  /// without a quick version, or a panel without data.
  Figure read(std::string const& name, bool quick) const;

  /// The sweep file of a data set.
  std::filesystem::path sweep(std::string const& data) const;

 private:
  std::filesystem::path file_;
  nlohmann::json figures_;
};

/// `given`; else inputs/figures/figures.toml from here or from where the program was built, or
/// where it is installed. Throws InputError where there is none.
std::filesystem::path find_figure_file(std::filesystem::path const& given);

}  // namespace bagnold::analysis
