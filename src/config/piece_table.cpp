// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/piece_table.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold {

void PieceTable::add(std::int64_t steps, double rate) {
  add(steps, rate, end_.strain + exact_product(rate, time_step_) * static_cast<double>(steps));
}

void PieceTable::add(std::int64_t steps, double rate, DoubleDouble const& strain_after) {
  pieces_.push_back(end_);
  pieces_.back().rate = rate;
  end_.begin += steps;
  end_.path += std::abs((strain_after + end_.strain * -1.0).rounded());
  end_.strain = strain_after;
}

PieceTable::Place PieceTable::place(std::int64_t step) const {
  std::int64_t const cycle = std::min(step / cycle_steps(), cycles_ - 1);
  auto const next =
      std::ranges::upper_bound(pieces_, step - cycle * cycle_steps(), {}, &Piece::begin);
  return {cycle, static_cast<std::size_t>(next - pieces_.begin()) - 1};
}

PieceTable::Stretch PieceTable::at(std::int64_t step) const {
  auto const [cycle, piece] = place(step);
  std::int64_t const first = cycle * cycle_steps(), end = first + after(piece).begin;
  return {first + pieces_[piece].begin, end == steps() ? never : end, pieces_[piece].rate};
}

DoubleDouble PieceTable::strain_before(Stretch const& stretch) const {
  auto const [cycle, piece] = place(stretch.begin);
  return end_.strain * static_cast<double>(cycle) + pieces_[piece].strain;
}

double PieceTable::strain(std::int64_t step) const {
  auto const stretch = at(step);
  return (strain_before(stretch) +
          exact_product(stretch.rate, time_step_) * static_cast<double>(step - stretch.begin))
      .rounded();
}

double PieceTable::path(std::int64_t step) const {
  auto const [cycle, piece] = place(step);
  auto const in_piece = static_cast<double>(step - cycle * cycle_steps() - pieces_[piece].begin);
  return end_.path * static_cast<double>(cycle) + pieces_[piece].path +
         std::abs(pieces_[piece].rate) * time_step_ * in_piece;
}

double PieceTable::mean_rate(std::int64_t begin, std::int64_t end) const {
  auto const stretch = at(begin);
  if (end <= stretch.end) return stretch.rate;
  return (strain(end) - strain(begin)) / (time_step_ * static_cast<double>(end - begin));
}

double PieceTable::typical_rate() const {
  return end_.path / (time_step_ * static_cast<double>(cycle_steps()));
}

}  // namespace bagnold
