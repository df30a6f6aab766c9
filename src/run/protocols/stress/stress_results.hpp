// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// Averages over the measured part of the time that one stress of several was held.
struct StressResult {
  double stress = 0;        ///< [m/tau_e^2]
  double strain = 0;        ///< of the measured part, mean over replicas
  std::size_t windows = 0;  ///< measured, of a replica
  std::vector<Observable> observables;
  std::vector<statistics::Estimate> estimates;  ///< of each
};

/// Results of each stress. The share shear.discard of its time is left out. Errors: as in a steady
/// run.
std::vector<StressResult> stress_results(Run const& run);

}  // namespace bagnold
