// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/config/scene.hpp"

namespace bagnold {

/// Where a run stands, as its folder tells while any process, or none, works on it.
struct RunStatus {
  enum class State { not_begun, running, stopped, failed, done };

  State state = State::not_begun;
  std::string holder;     ///< host and process, where one works on it
  std::string why;        ///< it failed
  double strain = 0;      ///< at the last checkpoint, mean over replicas; of one that is done, all
  double whole = 0;       ///< to which it is to go
  double work = 0;        ///< disk-steps so far
  double whole_work = 0;  ///< at its end
  double seconds = 0;     ///< of stepping so far
  double age = 0;         ///< of the last checkpoint, [s]; of one without, 0
  double since = 0;       ///< for how long it is at work since that, [s]; 0: nobody is
  std::vector<std::string> warnings, notes;  ///< their names, of one that is done

  double share() const { return whole_work > 0 ? work / whole_work : 0; }

  /// From now on, were it to go on as it did; nothing where that is not known.
  std::optional<double> seconds_left() const;
};

/// Of the folder of a run, or of a rate of a cascade. Reads the newest checkpoint of one that is
/// not done. InputError where the folder holds no run.
RunStatus status_of(std::filesystem::path const& folder);

/// Of a run that nobody has begun.
RunStatus status_not_begun(Scene const& scene);

/// Of a cascade in a folder, for each of its rates; nothing where it holds none.
std::vector<RunStatus> status_of_stages(std::filesystem::path const& folder);

/// "done", "not begun", ...
char const* word(RunStatus::State state);

}  // namespace bagnold
