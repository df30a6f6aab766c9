// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// Results near one strain rate, in one direction of the ramp.
struct LoopBin {
  double strain_rate = 0;                       ///< mean over its windows, [1/tau_e]
  std::size_t windows = 0;                      ///< of all passes
  std::vector<Observable> observables;          ///< at this rate
  std::vector<statistics::Estimate> estimates;  ///< of each
};

/// The hysteresis loop of a ramp.
struct Loop {
  std::vector<LoopBin> up, down;  ///< from the smallest rate on
};

inline constexpr int loop_bins_a_decade = 20;

/// Windows of all cycles and replicas in bins of equal width in log(gammadot) from the lowest rate
/// on, empty ones left out. Values are functions of the averages over a bin, with errors by passes
/// of cycles and replicas.
Loop loop_of(Run const& run);

}  // namespace bagnold
