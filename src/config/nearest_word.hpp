// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold {

/// The candidate that takes the fewest edits to become `given`, swaps of neighbours among them;
/// those of letters and digits before those of case, dots and dashes: Bp is B_p. "" where none is
/// like it: at most one letter of three is another, or one word is a part of the other.
std::string nearest_word(std::string const& given, std::vector<std::string> const& candidates);

/// "; did you mean CANDIDATE?", or `otherwise` where none is like it.
std::string did_you_mean(std::string const& given, std::vector<std::string> const& candidates,
                         std::string const& otherwise = "");

/// Letters and digits alone, small.
std::string bare(std::string const& word);

}  // namespace bagnold
