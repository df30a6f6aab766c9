// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/nearest_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <tuple>

namespace bagnold {

namespace {

/// Insertions, deletions, substitutions, and swaps of two letters beside each other.
std::size_t edits(std::string const& a, std::string const& b) {
  std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      next[j] = std::min({row[j - 1] + (a[i - 1] != b[j - 1]), row[j] + 1, next[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        next[j] = std::min(next[j], before[j - 2] + 1);
    }
    before.swap(row);
    row.swap(next);
  }
  return row.back();
}

constexpr std::size_t longest_word = 100;  ///< longer words are cut: they cost time

/// True if one word is the beginning or a part of the other: "--output" is --out, "rate" a
/// strain_rate.
bool is_part(std::string const& given, std::string const& candidate) {
  constexpr std::size_t fewest = 3;
  auto const one = bare(given), two = bare(candidate);
  if (std::min(one.size(), two.size()) < fewest) return false;
  if (one.starts_with(two) || two.starts_with(one)) return true;
  auto const at = candidate.rfind(given);
  return at != std::string::npos && at > 0 &&
         !std::isalnum(static_cast<unsigned char>(candidate[at - 1])) &&
         at + given.size() == candidate.size();
}

}  // namespace

std::string bare(std::string const& word) {
  std::string letters;
  for (unsigned char const c : word)
    if (std::isalnum(c)) letters += static_cast<char>(std::tolower(c));
  return letters;
}

std::string nearest_word(std::string const& given, std::vector<std::string> const& candidates) {
  auto const word = given.substr(0, longest_word);
  auto const is_near = [&](std::string const& candidate) {
    auto const length = std::max(bare(word).size(), bare(candidate).size());
    return edits(bare(word), bare(candidate)) <= length / 3 || is_part(word, candidate);
  };
  auto const cost = [&](std::string const& candidate) {  // of equals, one of the same length
    return std::tuple(edits(bare(word), bare(candidate)), edits(word, candidate),
                      candidate.size() != word.size());
  };
  std::vector<std::string> near;
  if (!bare(word).empty()) std::ranges::copy_if(candidates, std::back_inserter(near), is_near);
  if (near.empty()) return {};
  return *std::ranges::min_element(near,
                                   [&](auto const& a, auto const& b) { return cost(a) < cost(b); });
}

std::string did_you_mean(std::string const& given, std::vector<std::string> const& candidates,
                         std::string const& otherwise) {
  auto const meant = nearest_word(given, candidates);
  return meant.empty() ? otherwise : fmt::format("; did you mean {}?", meant);
}

}  // namespace bagnold
