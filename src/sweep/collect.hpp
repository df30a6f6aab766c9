// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "src/sweep/results.hpp"
#include "src/sweep/run_sweep.hpp"

namespace bagnold::sweep {

/// Writes sweep.csv and sweep.h5 of the points that are done; says on stderr how many are not, and
/// returns `incomplete` then. Throws FileError.
SweepEnd write_tables(Sweep const& sweep, SweepFolder const& folder, SweepMonitor& monitor);

/// One line for all points that have something to warn of, with what to do where more strain would
/// do, "" where none has; `folder` is the sweep's.
std::string suspect_points(Sweep const& sweep, Results const& results,
                           std::filesystem::path const& folder);

/// One line for all points that have notes, "" where none has.
std::string noted_points(Results const& results);

}  // namespace bagnold::sweep
