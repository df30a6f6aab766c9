// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace bagnold::io {

/// Name today of numbers of an engine or an observer, where checkpoints of older versions have
/// another one.
inline std::string name_now(std::string const& name) {
  constexpr std::pair<std::string_view, std::string_view> renamed[] = {
      // what bits depend on
      {"outer_drift", "outer_nonaffine_bound"},
      {"inner_drift", "inner_nonaffine_bound"},
      {"in_windows", "looking_ahead"},
      {"window_allowance", "lookahead_allowance"},
      {"window_usual_stray", "lookahead_usual_deviation"},
      {"window_allowance_steps", "lookahead_allowance_steps"},
      {"window_level", "lookahead_level"},
      {"window_cautious", "lookahead_cautious"},
      {"window_phase", "lookahead_phase"},
      {"window_cost", "lookahead_cost"},
      {"window_trial_cost", "lookahead_trial_cost"},
      {"enter_windows_below", "enter_lookahead_below"},
      {"lost_in_windows", "lost_in_lookahead"},
      // counters
      {"steps_dense", "steps_few_contacts"},
      {"windows", "lookaheads"},
      {"steps_in_windows", "lookahead_steps"},
      {"windows_refused", "lookaheads_refused"},
      {"touching_in_windows", "touching_in_lookahead"},
      // of observers
      {"contacts_looks", "contacts_samples"}};
  for (auto const& [before, now] : renamed)
    if (name == before) return std::string(now);
  return name;
}

}  // namespace bagnold::io
