// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/sweep/sweep_table.hpp"

namespace bagnold::sweep {

/// One run of a sweep.
struct Point {
  std::string folder;         ///< name of its folder, "0003_elasticity=10_seed=2"
  std::vector<Value> values;  ///< of the varied keys
  std::string name;           ///< for messages: "point 3 of 20 (disks.elasticity = 10, ...)"
  std::optional<std::size_t> previous;  ///< the point whose last state it starts from
  Scene scene;  ///< resolved; with `previous`, start.file is relative to the point's folder
  Plan plan;
};

/// A sweep file, expanded. Points are in the file's order: rows of zip, in each the grid with its
/// last key fastest.
struct Sweep {
  std::string origin;             ///< the file
  std::string command = "sweep";  ///< of `bagnold`, that goes on with it
  std::string options;            ///< that this command needs, " --set 'disks.seed=3'"
  std::string text;               ///< all of it
  std::string base;               ///< without its table [sweep], as TOML
  std::vector<std::string> keys;  ///< the varied keys, zip before grid
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> chains;  ///< points done one after another
};

/// Checks of each scene beyond its form; throws InputError.
using PointCheck = std::function<void(Scene const& scene, Plan const& plan)>;

/// Reads a sweep file and expands, plans and checks every point. Throws InputError naming the file,
/// the point and the key.
Sweep read_sweep(std::filesystem::path const& file, PointCheck const& check);

/// Reads a sweep from text. `origin` names the text in messages; start.file is relative to
/// `folder`.
Sweep parse_sweep(std::string const& text, std::string const& origin,
                  std::filesystem::path const& folder, PointCheck const& check);

}  // namespace bagnold::sweep
