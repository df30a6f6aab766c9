// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace bagnold::quasi_static {

/// A block of a symmetric matrix below its diagonal, row > column.
struct Entry {
  std::int32_t row, column;

  friend bool operator==(Entry const&, Entry const&) = default;
};

/// Nonzero blocks of the Cholesky factor L of a symmetric matrix: those of the matrix and those
/// that elimination fills in, by the elimination tree (Davis, Direct Methods for Sparse Linear
/// Systems, Secs. 4.1-4.4).
struct FactorPattern {
  std::vector<std::int32_t> first;  ///< [N + 1] of each column in `row`
  std::vector<std::int32_t> row;    ///< of column k: k, then those below, rising
  std::vector<char> last_of_group;  ///< [N] of neighbouring columns with the same rows below them

  FactorPattern() = default;
  FactorPattern(std::int32_t columns, std::vector<Entry> const& entries);

  /// One past the last column of the group that begins with this one.
  std::size_t group_end(std::size_t column) const {
    while (!last_of_group[column]) ++column;
    return column + 1;
  }

  /// Place of a block in `row`; it must exist.
  std::size_t find(Entry const& entry) const;
};

}  // namespace bagnold::quasi_static
