// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// A sweep in a folder that may hold points of it, or of an earlier form of its file.
struct PlacedPoints {
  /// Sweep in which each point has the folder of the existing one, found by its resolved scene; new
  /// ones are numbered after all existing ones.
  Sweep sweep;

  /// A point of points.json that is not in the sweep.
  struct Left {
    std::string folder;
    std::string scene;  ///< resolved, TOML
  };
  std::vector<Left> left;

  /// Folders of points that were prepared for another form of the file and have not begun: the
  /// sweep replaces them.
  std::vector<std::string> withdrawn;

  std::size_t kept = 0;             ///< points that were there
  std::vector<std::size_t> longer;  ///< of these, with less strain, from which no other starts
  std::size_t begun_with() const { return kept + left.size(); }  ///< points that are there
  std::size_t added() const { return sweep.points.size() - kept; }
};

/// Finds the points of a sweep in points.json of a folder. A point exists if its resolved scene
/// does, its start.file included, or the same with less shear.strain, if no other point starts from
/// its last state. If no existing point has begun, another sweep replaces them; otherwise throws
/// InputError for a sweep none of whose points exists.
PlacedPoints place_points(Sweep const& sweep, std::filesystem::path const& folder);

/// True if no run has begun in the folder of a point: it has no lock and no file but those of its
/// preparation.
bool not_begun(std::filesystem::path const& point);

/// Message on changes since the folder was last used; "" if there are none.
std::string changes(PlacedPoints const& placed);

}  // namespace bagnold::sweep
