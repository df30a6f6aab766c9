// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/nearest_word.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

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

}  // namespace

std::string nearest_word(std::string const& word, std::vector<std::string> const& candidates) {
  auto const cost = [&](std::string const& candidate) {  // of equals, one of the same length
    return std::pair(edits(word, candidate), candidate.size() != word.size());
  };
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](auto const& a, auto const& b) { return cost(a) < cost(b); });
}

}  // namespace bagnold
