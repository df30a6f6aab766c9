// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/analysis/figures/figure_file.hpp"
#include "src/analysis/figures/figure_maker.hpp"
#include "src/analysis/figures/stated.hpp"
#include "src/sweep/run_sweep.hpp"

namespace bagnold::analysis {

/// A figure to be made.
struct FigureRequest {
  std::string name;            ///< "P2-15"
  bool quick = false;          ///< its small version
  std::filesystem::path out;   ///< folder for pictures, and for data that figures share
  std::filesystem::path data;  ///< folder of finished tables to draw from; "": run sweeps
  ReadWords read;              ///< words of its analyses
  sweep::SweepOptions sweeps = {};
};

/// A figure whose tables are written.
struct PreparedFigure {
  Figure figure;
  sweep::SweepEnd sweeps;          ///< the rest is there unless they were stopped
  std::filesystem::path recipe;    ///< for draw_figure() (src/run/plot.hpp)
  std::filesystem::path picture;   ///< OUT/NAME.png, or OUT/NAME-quick.png
  std::vector<Comparison> stated;  ///< what the text of the paper states, beside what is found
};

/// Runs the sweeps of a figure that are not done, analyses them, and writes the tables and the
/// recipe of its picture into OUT/NAME. `file` is the file of figures, find_figure_file(). Mistakes
/// in the figure are reported before anything runs. Throws InputError, and as sweep::run() does.
PreparedFigure prepare_figure(std::filesystem::path const& file, FigureRequest const& request);

/// Shows every figure of a file, and whether it has a quick version, each checked as
/// prepare_figure() does. Throws InputError.
void list_figures(std::filesystem::path const& file, ReadWords const& read,
                  std::function<void(Figure const& figure, bool has_quick)> const& show);

}  // namespace bagnold::analysis
