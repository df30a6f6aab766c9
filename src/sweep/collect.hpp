// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "src/sweep/results.hpp"
#include "src/sweep/run_sweep.hpp"

namespace bagnold::sweep {

/// Writes sweep.csv and sweep.h5 of the points that are done. If some are not, prints their number
/// on stderr and returns `incomplete`. Throws FileError.
SweepEnd write_tables(Sweep const& sweep, SweepFolder const& folder, SweepMonitor& monitor);

/// One line for all points with warnings, with what to do if more strain would help; "" if there
/// are none. `folder` is the sweep's.
std::string suspect_points(Sweep const& sweep, Results const& results,
                           std::filesystem::path const& folder);

/// One line for all points with notes; "" if there are none.
std::string noted_points(Results const& results);

}  // namespace bagnold::sweep
