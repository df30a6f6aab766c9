// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/analysis/sweep_table.hpp"

namespace bagnold::analysis {

/// What all data of a sweep tell together of the errors of one observable's runs, a datum being
/// points that differ in disks.seed only.
struct SeedErrors {
  /// How many times as much seeds scatter as their errors tell, at least 1: block errors of runs
  /// that remember longer than they last are too small, by about as much everywhere.
  double factor = 1.0;
  /// Error over mean of a run that has no error of its own: from the scatter of the seeds of such
  /// data where they have at least 8 degrees of freedom, else the root mean square of the errors
  /// that others have. NaN where there are none of either.
  double relative;
};

/// Pooled over all data but those whose seeds scatter more than chance allows once in a thousand:
/// they speak for themselves (merge_seeds).
SeedErrors seed_errors(SweepTable const& table, Measured const& measured);

}  // namespace bagnold::analysis
