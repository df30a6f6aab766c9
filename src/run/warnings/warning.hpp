// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// Warning on a finished run: its numbers may be wrong (`warnings` of summary.json). A note says
/// what they describe, such as disks that are not as hard as they could be (`notes`).
struct Warning {
  std::string name;                                     ///< for programs: "steady_state"
  std::vector<std::pair<std::string, double>> numbers;  ///< numbers behind it
  std::string reason;                                   ///< with the numbers, no full stop
  std::string remedy;                                   ///< what to do about it
  std::string command = {};  ///< that does it; DIR stands for the folder of the run; may be empty
  bool is_note = false;
};

/// A finished run, as input of checks.
struct FinishedRun {
  Run const& run;
  std::vector<NamedEstimate> const& found;  ///< of estimates(run): empty of a ramp

  /// Estimate of a name of summary.json; null if there is none.
  NamedEstimate const* of(std::string_view name) const;

  /// Mean of a name over all replicas; NaN if there is none.
  double mean(std::string_view name) const;

  double measured_strain() const;  ///< of each replica

  /// L_x L_y; where a pressure is held, that at the mean packing fraction, [d_s^2].
  double box_area() const;

  /// Value of a name of /series in a window, or in a frame if it is measured on frames; mean over
  /// replicas.
  double in_window(std::string_view name, std::size_t window) const;

  /// Absolute change of a function of the window from the first to the last measured window.
  template <class Function>
  double change(Function const& function) const {
    auto const first = static_cast<std::size_t>(run.plan.discarded_windows);
    auto const last = static_cast<std::size_t>(run.plan.windows) - 1;
    return std::abs(function(last) - function(first));
  }
};

/// All warnings and notes of a run, in a fixed order.
std::vector<Warning> warnings(FinishedRun const& finished);

/// "name: reason; remedy: `command`", for the terminal.
std::string text_of(Warning const& warning, std::string const& folder);

/// `text` with the folder of a run for DIR.
std::string with_folder(std::string text, std::string const& folder);

/// Command that makes the run `times` times as long, with a round strain: "bagnold resume DIR
/// --strain 40". At given stress, whose length is a time, and after a target error was met, it runs
/// the scene anew.
std::string longer_run(Run const& run, double times);

/// Command that makes the run long enough for errors that are not rough: each quantity then has
/// `enough_windows` independent windows. "" if all have, or nothing is known.
std::string until_errors(FinishedRun const& finished);

/// Independent windows that an error needs: 8 blocks of 4.
inline constexpr double enough_windows = 4 * statistics::fewest_blocks;

/// Smallest number of independent windows of the quantities with no error or a rough one; infinity
/// if there are none.
double fewest_independent_windows(FinishedRun const& finished);

/// Command that runs the scene of a run with a key changed, "bagnold run DIR/scene.toml --set
/// KEY=VALUE --out DIR-KEY".
std::string changed_run(std::string const& key, std::string const& value);

}  // namespace bagnold
