// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/piece_history.hpp"

#include <algorithm>

namespace bagnold {

namespace {

constexpr std::size_t numbers_of_piece = 4;

}  // namespace

PieceHistory::PieceHistory(std::vector<double> const& numbers) {
  for (std::size_t k = 0; k + numbers_of_piece <= numbers.size(); k += numbers_of_piece)
    pieces_.push_back(
        {static_cast<std::int64_t>(numbers[k]), numbers[k + 1], {numbers[k + 2], numbers[k + 3]}});
}

PieceHistory::Stretch PieceHistory::at(std::int64_t step) const {
  auto const next = std::ranges::upper_bound(pieces_, step, {}, &Piece::begin);
  auto const here = next == pieces_.begin() ? next : std::prev(next);
  return {here->begin, here + 1 == pieces_.end() ? never : (here + 1)->begin, here->rate};
}

DoubleDouble PieceHistory::strain_before(Stretch const& stretch) const {
  return std::ranges::lower_bound(pieces_, stretch.begin, {}, &Piece::begin)->strain;
}

void PieceHistory::begin(std::int64_t step, double rate, DoubleDouble const& strain) {
  pieces_.push_back({step, rate, strain});
}

void PieceHistory::forget_before(std::int64_t step) {
  auto const next = std::ranges::upper_bound(pieces_, step, {}, &Piece::begin);
  if (next != pieces_.begin()) pieces_.erase(pieces_.begin(), std::prev(next));
}

std::vector<double> PieceHistory::numbers() const {
  std::vector<double> all;
  for (auto const& [begin, rate, strain] : pieces_)
    all.insert(all.end(), {static_cast<double>(begin), rate, strain.high, strain.low});
  return all;
}

}  // namespace bagnold
