// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/config/scene.hpp"

namespace bagnold {

/// Status of a run, read from its folder while any process, or none, works on it.
struct RunStatus {
  enum class State { not_begun, running, stopped, failed, done };

  State state = State::not_begun;
  std::string holder;           ///< host and process, where one works on it
  std::string why;              ///< it failed
  std::string name = "strain";  ///< of what follows: strain, or the time, [tau_e]
  double strain = 0;      ///< at the last checkpoint, mean over replicas; of one that is done, all
  double whole = 0;       ///< to which it is to go
  double work = 0;        ///< disk-steps so far
  double whole_work = 0;  ///< at its end
  double seconds = 0;     ///< of stepping so far
  double age = 0;         ///< of the last checkpoint, [s]; of one without, 0
  double since = 0;       ///< time of work since then, [s]; 0: no process works
  std::vector<std::string> warnings, notes;  ///< their names, of one that is done

  double share() const { return whole_work > 0 ? work / whole_work : 0; }

  /// Remaining time at the present pace, [s]; nothing if it is not known.
  std::optional<double> seconds_left() const;
};

/// Status of a run, or of a rate of a cascade, by its folder. Reads the newest checkpoint if the
/// run is not done. InputError where the folder holds no run.
RunStatus status_of(std::filesystem::path const& folder);

/// Status of a run that has not begun.
RunStatus status_not_begun(Scene const& scene);

/// Status of each rate of a cascade in a folder; empty where it holds none.
std::vector<RunStatus> status_of_stages(std::filesystem::path const& folder);

/// "done", "not begun", ...
char const* word(RunStatus::State state);

}  // namespace bagnold
