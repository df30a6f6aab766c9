// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace bagnold {

/// Index of the cell (x, y) on the Hilbert curve through a 2^level x 2^level grid. Cells with near
/// indices are near in the plane.
inline std::uint64_t hilbert_index(int level, std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t half = level == 0 ? 0 : 1u << (level - 1); half > 0; half /= 2) {
    bool const right = (x & half) != 0, up = (y & half) != 0;
    index += static_cast<std::uint64_t>(half) * half * ((right ? 3u : 0u) ^ (up ? 1u : 0u));
    if (up) continue;
    if (right) {  // turn the lower quadrants as the curve does
      x = half - 1 - (x & (half - 1));
      y = half - 1 - (y & (half - 1));
    }
    std::uint32_t const swapped = x;
    x = y;
    y = swapped;
  }
  return index;
}

/// Cells of a grid, numbered row by row, in the order of the Hilbert curve.
inline std::vector<std::uint32_t> cells_along_curve(int columns, int rows) {
  int level = 0;
  while ((1 << level) < std::max(columns, rows)) ++level;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells;
  cells.reserve(static_cast<std::size_t>(rows) * columns);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      cells.emplace_back(hilbert_index(level, x, y), static_cast<std::uint32_t>(y) * columns + x);
  std::sort(cells.begin(), cells.end());
  std::vector<std::uint32_t> order;
  order.reserve(cells.size());
  for (auto const& cell : cells) order.push_back(cell.second);
  return order;
}

}  // namespace bagnold
