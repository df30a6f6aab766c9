// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bagnold {

/// Candidate that takes the fewest edits to become `given`, swaps of neighbours included; edits of
/// letters and digits count more than those of case, dots and dashes: Bp is B_p. "" if none is
/// close: at most one letter of three differs, or one word is a part of the other.
std::string nearest_word(std::string const& given, std::vector<std::string> const& candidates);

/// "; did you mean CANDIDATE?", or `otherwise` if none is close.
std::string did_you_mean(std::string const& given, std::vector<std::string> const& candidates,
                         std::string const& otherwise = "");

/// Letters and digits of a word, in small letters.
std::string bare(std::string const& word);

}  // namespace bagnold
