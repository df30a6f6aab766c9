// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "src/analysis/csv.hpp"

namespace bagnold::analysis {

/// A number that a paper states in its text, with the measured one.
struct Comparison {
  std::string what, source;
  std::string stated, ours;
  std::string deviation;  ///< in standard errors of both, "-" where none is known; of what is
                          ///< stated with "about" in per cent, and in our errors
  std::string agrees;     ///< "yes" within two errors or the bounds, of "about" beyond what its
                          ///< last digit leaves open; "no", where no error is known too; "untold"
                          ///< within bounds that our error exceeds; "" without ours
};

/// The rows of an analysis that the entry of a figure names, each against what is stated; one that
/// says so where there is none.
///
/// entry: what, source, column (of the analysis), `stated` (a number, or [low, high]), perhaps
/// `error` of it or `about` = half of its last digit's unit (true: it has no digits), and perhaps
/// `row` = {KEY = VALUE}: the rows to look at.
std::vector<Comparison> compare(nlohmann::json const& entry, Rows const& results);

/// Aligned lines, for the terminal.
std::string to_lines(std::vector<Comparison> const& list);

Rows to_rows(std::vector<Comparison> const& list);

}  // namespace bagnold::analysis
