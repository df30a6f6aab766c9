// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
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

/// The finite number that the text of a cell is, none where it is another text.
std::optional<double> number_in(std::string const& text);

/// RFC 4180, lines ended by a line feed: equal tables give equal bytes.
std::string to_csv(Rows const& rows);

/// The table of a text as to_csv writes it, RFC 4180 with either end of line. Throws InputError
/// with the line: a quote left open, a row of another length than the names.
Rows parse_csv(std::string const& text, std::string const& origin);

}  // namespace bagnold::analysis
