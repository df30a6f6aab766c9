// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/analysis/sweep_table.hpp"

namespace bagnold::analysis {

/// Errors of one observable's runs, pooled over all data of a sweep. A datum is the set of points
/// that differ in disks.seed only.
struct SeedErrors {
  /// Scatter of seeds over their errors, at least 1. Block errors of runs that are shorter than
  /// their correlation time are too small, by about the same factor everywhere.
  double factor = 1.0;
  /// Error over mean of a run that has no error of its own: from the scatter of the seeds of such
  /// data if they have at least 8 degrees of freedom, otherwise the root mean square of the errors
  /// of other runs. NaN if there are none of either.
  double relative;
};

/// Pools all data but those whose seeds scatter more than chance allows once in a thousand: these
/// use their own scatter (merge_seeds).
SeedErrors seed_errors(SweepTable const& table, Measured const& measured);

}  // namespace bagnold::analysis
