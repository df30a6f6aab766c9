// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// A sweep in a folder that may hold points of it, or of an earlier form of its file.
struct PlacedPoints {
  /// Each point has the folder of the one that is there, known by its resolved scene; new ones are
  /// numbered behind all that are there.
  Sweep sweep;

  /// A point of points.json that is not in the sweep.
  struct Left {
    std::string folder;
    std::string scene;  ///< resolved, TOML
  };
  std::vector<Left> left;

  /// Folders of points that were prepared, of which none has begun, for another form of the file:
  /// the sweep takes their place.
  std::vector<std::string> withdrawn;

  std::size_t kept = 0;             ///< points that were there
  std::vector<std::size_t> longer;  ///< of these, with less strain, from which no other starts
  std::size_t begun_with() const { return kept + left.size(); }  ///< points that are there
  std::size_t added() const { return sweep.points.size() - kept; }
};

/// Finds the points of a sweep in points.json of a folder. A point is there where its resolved
/// scene is, its start.file included, or the same with less shear.strain, if no other point starts
/// from its last state. Where none of the points that are there has begun, another sweep takes
/// their place; else throws InputError for one of which no point is there.
PlacedPoints place_points(Sweep const& sweep, std::filesystem::path const& folder);

/// Whether nobody has begun the point in a folder: no file but those of its preparation, no lock.
bool not_begun(std::filesystem::path const& point);

/// What has changed since the folder was last used, for its user; "" where nothing has.
std::string changes(PlacedPoints const& placed);

}  // namespace bagnold::sweep
