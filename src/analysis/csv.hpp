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

/// Number in the text of a cell, if it is a finite number.
std::optional<double> number_in(std::string const& text);

/// RFC 4180, lines ended by a line feed: equal tables give equal bytes.
std::string to_csv(Rows const& rows);

/// Reads a table as to_csv writes it, RFC 4180 with either end of line. Throws InputError with the
/// line for a quote left open or a row whose length differs from that of the names.
Rows parse_csv(std::string const& text, std::string const& origin);

}  // namespace bagnold::analysis
