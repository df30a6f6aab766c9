// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// What was measured, beside what the papers state, on stdout: what most people look at, or all of
/// it. `folder` is what `bagnold resume` makes longer; "": nothing does.
void print_table(Run const& run, std::vector<NamedEstimate> const& list, std::string const& folder,
                 bool all);

}  // namespace bagnold
