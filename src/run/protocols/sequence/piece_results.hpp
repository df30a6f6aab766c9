// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/run/results.hpp"
#include "src/statistics/tables.hpp"

namespace bagnold {

/// Averages over the later part of a piece of a sequence.
struct PieceResult {
  double strain_rate = 0;               ///< [1/tau_e]
  double begin_strain = 0, strain = 0;  ///< in the first cycle: at the beginning, and of the piece
  double begin_time = 0, time = 0;      ///< the same, from step 0, [tau_e]
  std::size_t windows = 0;              ///< measured, of all cycles and replicas
  std::vector<Observable> observables;
  std::vector<statistics::Estimate> estimates;  ///< of each
};

/// Results of each piece of a cycle. The share shear.discard of the time of each piece is left out,
/// to whole windows. Windows of a stop, each longer than the one before, count by their time.
/// Errors: by the jackknife over replicas from 3 on, otherwise over cycles, from
/// 3 on; of a single pass by blocks of its windows, where it flows.
std::vector<PieceResult> piece_results(Run const& run);

/// Beginning and end of the pieces of all cycles, with the numbers of their windows, for result.h5.
statistics::Samples piece_table(Run const& run);

}  // namespace bagnold
