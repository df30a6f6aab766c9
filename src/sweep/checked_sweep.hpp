// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "src/sweep/sweep.hpp"

namespace bagnold::sweep {

/// Reads a sweep file with all its points, each checked as `bagnold run` would check it, state
/// files included if they exist already. A warning on a plan goes to stderr, once for all points.
/// Throws InputError naming the file, the point and the key.
Sweep read_checked_sweep(std::filesystem::path const& file, bool allow_unstable = false);

/// Check of each point in read_checked_sweep(); `allow_unstable` accepts a time step beyond the
/// scheme's stability.
PointCheck point_check(bool allow_unstable);

/// Note on chains that go from a slow rate to a faster one; "" if there are none.
std::string rising_chain_note(Sweep const& sweep);

}  // namespace bagnold::sweep
