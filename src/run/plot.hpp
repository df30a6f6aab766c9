// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace bagnold {

/// Draw the picture of a result with Python and matplotlib. Returns what went wrong, "" if nothing:
/// a run without a picture is still a run.
std::string draw_plot(std::filesystem::path const& result, std::filesystem::path const& picture);

/// The same for profiles.png and fields.png, of what the result has of them.
std::string draw_frames(std::filesystem::path const& result, std::filesystem::path const& folder);

/// The same of an analysis, from its table of what is to be drawn (scripts/plot_analysis.py).
std::string draw_analysis(std::filesystem::path const& drawn, std::filesystem::path const& picture);

/// The same of a figure of the papers, from its recipe (scripts/plot_figure.py). Python's own
/// errors go to stderr: a recipe is written by hand.
std::string draw_figure(std::filesystem::path const& recipe, std::filesystem::path const& picture);

}  // namespace bagnold
