// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/nearest_word.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <tuple>

namespace bagnold {

namespace {

std::size_t edits(std::string const& a, std::string const& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t const substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

constexpr std::size_t longest = 100;  ///< the rest tells nothing, and takes long

/// Small letters and digits alone.
std::string bare(std::string const& word) {
  std::string letters;
  for (unsigned char const c : word)
    if (std::isalnum(c)) letters += static_cast<char>(std::tolower(c));
  return letters;
}

}  // namespace

std::string nearest_word(std::string const& given, std::vector<std::string> const& candidates) {
  auto const word = given.substr(0, longest);
  auto const cost = [&](std::string const& candidate) {  // of equals, one of the same length
    return std::tuple(edits(bare(word), bare(candidate)), edits(word, candidate),
                      candidate.size() != word.size());
  };
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](auto const& a, auto const& b) { return cost(a) < cost(b); });
}

}  // namespace bagnold
