// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/cli/run_results.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// What makes a finished run's result suspect. `warnings` of summary.json.
struct Warning {
  std::string name;                                     ///< for programs: "steady_state"
  std::vector<std::pair<std::string, double>> numbers;  ///< what it was seen by
  std::string reason;                                   ///< with the numbers, no full stop
  std::string remedy;                                   ///< what to do about it
};

/// A finished run as checks see it.
struct Finished {
  Run const& run;
  std::vector<NamedEstimate> const& found;  ///< of estimates(run): empty of a ramp
  std::vector<State> const& last;           ///< [R], the last states

  /// What was found under a name of summary.json; null where there is none.
  NamedEstimate const* of(std::string_view name) const;

  /// Its mean over all replicas; NaN where there is none.
  double mean(std::string_view name) const;

  double measured_strain() const;  ///< of each replica
};

/// All that is to be warned of, in a fixed order; none where all is well.
std::vector<Warning> warnings(Finished const& finished);

/// "name: reason; remedy", for the terminal.
std::string text_of(Warning const& warning);

}  // namespace bagnold
