// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace bagnold {

/// Draws the picture of a result, of the folder of a cascade or a sweep, or of an analysis from its
/// table PREFIX.drawn.csv, with the Python package (python/bagnold/plots). Returns the failure, ""
/// if there is none: a run without a picture is still a run.
std::string draw_plot(std::filesystem::path const& result, std::filesystem::path const& picture);

/// Draws profiles.png, fields.png and histograms.png into a folder, as far as the result has their
/// data.
std::string draw_frames(std::filesystem::path const& result, std::filesystem::path const& folder);

/// Draws a figure of the papers, from its recipe.json. Python's own errors go to stderr: a recipe
/// is written by hand.
std::string draw_figure(std::filesystem::path const& recipe, std::filesystem::path const& picture);

}  // namespace bagnold
