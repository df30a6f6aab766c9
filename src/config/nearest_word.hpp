// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold {

/// The candidate that takes the fewest edits to become `word` (Levenshtein distance).
std::string nearest_word(std::string const& word, std::vector<std::string> const& candidates);

}  // namespace bagnold
