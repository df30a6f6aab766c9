// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "src/analysis/figures/figure_file.hpp"

namespace bagnold::analysis {

/// Folder with the data sets of a figure.
struct DataFolder {
  std::filesystem::path folder;
  bool tables = false;  ///< NAME.csv and NAME.json instead of folders of sweeps

  /// The folder of a data set's sweep.
  std::filesystem::path sweep(std::string const& name) const { return folder / name; }

  /// Input of an analysis (read_sweep_table).
  std::filesystem::path measured(std::string const& name) const {
    return folder / (tables ? name + ".csv" : name);
  }

  /// Input of panels other than analyses: histograms, profiles, series.
  std::filesystem::path pictured(std::string const& name) const {
    return folder / (tables ? name + ".json" : name);
  }
};

/// Warns of the data sets of a figure that are not in a folder of tables; throws InputError where
/// none of them is.
void check_tables(Figure const& figure, DataFolder const& data);

}  // namespace bagnold::analysis
