// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/kinds/kinds.hpp"

namespace bagnold::analysis {

/// A kind of analysis by name, and what is asked of it.
struct KindRequest {
  std::string kind;
  Request request = {};
};

/// Result of an analysis, and its files.
struct Analysis {
  Kind const* kind;
  Report report;
  std::filesystem::path results;  ///< PREFIX.csv
  std::filesystem::path drawn;    ///< PREFIX.drawn.csv, what the picture shows
  std::filesystem::path picture;  ///< PREFIX.png, for draw_plot() (src/run/plot.hpp)
};

/// Analyses the tables of sweeps (folders, or files as of read_sweep_table), joined, and writes its
/// two tables, as `bagnold analyse` does. An empty `prefix` is the kind's name in the folder of the
/// first sweep. Throws InputError where the kind or the table is not there, or nothing is found;
/// FileError.
Analysis analyse(std::vector<std::filesystem::path> const& sweeps, KindRequest const& asked,
                 std::filesystem::path prefix = {});
inline Analysis analyse(std::filesystem::path const& sweep, KindRequest const& asked,
                        std::filesystem::path prefix = {}) {
  return analyse(std::vector{sweep}, asked, std::move(prefix));
}

}  // namespace bagnold::analysis
