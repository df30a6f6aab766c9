// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold {

/// The candidate that takes the fewest edits to become `given` (Levenshtein distance), those of
/// letters and digits before those of case, dots and dashes: Bp is B_p.
std::string nearest_word(std::string const& given, std::vector<std::string> const& candidates);

}  // namespace bagnold
