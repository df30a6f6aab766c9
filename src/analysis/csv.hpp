// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold::analysis {

/// A table of texts; numbers in the shortest form that reads back to the same double, empty for
/// NaN.
struct Rows {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

std::string cell(double value);

/// RFC 4180, lines ended by a line feed: equal tables give equal bytes.
std::string to_csv(Rows const& rows);

}  // namespace bagnold::analysis
