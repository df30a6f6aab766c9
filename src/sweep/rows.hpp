// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/sweep/sweep_table.hpp"

namespace bagnold::sweep {

/// Values of the varied keys at a point, and the chain of the point.
struct Row {
  std::vector<VariedKey::Given const*> values;  ///< keys of zip, then of grid
  std::size_t chain = 0;                        ///< numbered in the order of their first points
};

/// All points in the file's order: for every row of zip, the grid with its last key fastest. Points
/// that differ in the chain key only are one chain; where that key is in zip, those that differ in
/// the row of zip only, and a row that gives start.kind = "random" begins another chain. Without a
/// chain key every point is a chain. Throws InputError beyond 10^5 points. The rows point into
/// `table`.
std::vector<Row> rows(SweepTable const& table, std::string const& origin);

}  // namespace bagnold::sweep
