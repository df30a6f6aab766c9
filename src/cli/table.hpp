// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// Prints measured values beside those of the papers on stdout: the most used ones, or all of them.
/// `folder`: folder for `bagnold resume` to make the run longer; "" if it cannot be.
void print_table(Run const& run, std::vector<NamedEstimate> const& list, std::string const& folder,
                 bool all);

}  // namespace bagnold
