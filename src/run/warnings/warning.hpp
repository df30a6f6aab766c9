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

/// What makes a finished run's result suspect. `warnings` of summary.json.
struct Warning {
  std::string name;                                     ///< for programs: "steady_state"
  std::vector<std::pair<std::string, double>> numbers;  ///< what it was seen by
  std::string reason;                                   ///< with the numbers, no full stop
  std::string remedy;                                   ///< what to do about it
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

/// "name: reason; remedy", for the terminal.
std::string text_of(Warning const& warning);

}  // namespace bagnold
