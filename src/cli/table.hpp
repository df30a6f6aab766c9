// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// What was measured, beside what the papers state, on stdout.
void print_table(Run const& run, std::vector<NamedEstimate> const& list);

}  // namespace bagnold
