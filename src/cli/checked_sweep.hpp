// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "src/run/run_time_estimate.hpp"
#include "src/sweep/sweep.hpp"

namespace bagnold {

/// A sweep file with all its points, each checked as `bagnold run` would check it, state files
/// included where they are there already. Says on stderr what a user should know. Throws
/// InputError.
sweep::Sweep read_checked_sweep(std::filesystem::path const& file, bool allow_unstable);

/// What read_checked_sweep() asks of each point.
sweep::PointCheck point_check(bool allow_unstable);

/// What all points take on one core.
RunTimes times_of_points(sweep::Sweep const& sweep);

}  // namespace bagnold
