// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// What to know of a finished run's result: that its numbers may be wrong, `warnings` of
/// summary.json, or what they are of, such as disks not so hard as could be, `notes`.
struct Warning {
  std::string name;                                     ///< for programs: "steady_state"
  std::vector<std::pair<std::string, double>> numbers;  ///< what it was seen by
  std::string reason;                                   ///< with the numbers, no full stop
  std::string remedy;                                   ///< what to do about it
  std::string command = {};  ///< that does it; DIR stands for the folder of the run; may be empty
  bool is_note = false;
};

/// A finished run as checks see it.
struct FinishedRun {
  Run const& run;
  std::vector<NamedEstimate> const& found;  ///< of estimates(run): empty of a ramp

  /// What was found under a name of summary.json; null where there is none.
  NamedEstimate const* of(std::string_view name) const;

  /// Its mean over all replicas; NaN where there is none.
  double mean(std::string_view name) const;

  double measured_strain() const;  ///< of each replica

  /// What a name of /series was in a window, mean over replicas; of one of frames, in a frame.
  double in_window(std::string_view name, std::size_t window) const;

  /// Change of a function of the window from the first to the last of those measured, without sign.
  template <class Function>
  double change(Function const& function) const {
    auto const first = static_cast<std::size_t>(run.plan.discarded_windows);
    auto const last = static_cast<std::size_t>(run.plan.windows) - 1;
    return std::abs(function(last) - function(first));
  }
};

/// All that is to be warned of, in a fixed order; none where all is well.
std::vector<Warning> warnings(FinishedRun const& finished);

/// "name: reason; remedy: `command`", for the terminal.
std::string text_of(Warning const& warning, std::string const& folder);

/// `text` with the folder of a run for DIR.
std::string with_folder(std::string text, std::string const& folder);

/// The command that makes a run so many times as long, in a round strain: "bagnold resume DIR
/// --strain 40".
std::string longer_run(Run const& run, double times);

/// The command that makes it long enough for errors that are not rough: each quantity is worth
/// `enough_windows` then. "" where all are, or nothing tells.
std::string until_errors(FinishedRun const& finished);

/// Independent windows that an error takes: 8 blocks of 4.
inline constexpr double enough_windows = 4 * statistics::fewest_blocks;

/// The fewest that a quantity without an error, or with a rough one, is worth; infinity: none is.
double fewest_independent_windows(FinishedRun const& finished);

/// The command that runs the scene of a run with a key changed, "bagnold run DIR/scene.toml --set
/// KEY=VALUE --out DIR-KEY".
std::string changed_run(std::string const& key, std::string const& value);

}  // namespace bagnold
