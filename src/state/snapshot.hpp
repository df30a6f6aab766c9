// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/state/state.hpp"

namespace bagnold {

/// All data that a simulation needs to continue bit for bit.
struct Snapshot {
  State state;  ///< as the engine holds it, outside the box perhaps
  std::vector<std::array<double, 2>> list_position;   ///< [N], at the last list build, [d_s]
  std::int64_t list_step = 0;                         ///< step of that build
  std::int64_t step = 0;                              ///< steps done
  double initial_offset = 0.0;                        ///< at step 0, [d_s]
  double initial_time = 0.0;                          ///< at step 0, [tau_e]
  std::int64_t list_builds = 0;                       ///< so far
  std::map<std::string, double> memory;               ///< other numbers on which the bits depend
  std::map<std::string, std::vector<double>> arrays;  ///< memory with many numbers each
  std::map<std::string, double> counters;             ///< of the engine, for reports
};

/// A system at step 0, without a list.
inline Snapshot first_snapshot(State state) {
  Snapshot snapshot;
  snapshot.initial_offset = state.offset;
  snapshot.initial_time = state.time;
  snapshot.state = std::move(state);
  return snapshot;
}

}  // namespace bagnold
