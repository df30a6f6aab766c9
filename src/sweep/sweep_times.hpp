// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/run/run_time_estimate.hpp"
#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// Times of the points of a sweep on one core, in the file's order, from trials of some of them
/// (src/run/run_time_estimate.hpp). Starts Kokkos if it does not run yet.
RunTimes times_of_points(Sweep const& sweep);

/// Time of the longest chain, `times` being those of the points: a lower bound for any number of
/// cores.
RunTime longest_chain(Sweep const& sweep, RunTimes const& times);

/// Disks times steps, of all points.
double disk_steps(Sweep const& sweep);

}  // namespace bagnold::sweep
