// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/block_cholesky.hpp"

#include <cmath>

namespace bagnold::quasi_static {

namespace {

constexpr std::int32_t last = -1;

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

}  // namespace

template <int unknowns>
void BlockCholesky<unknowns>::clear(FactorPattern const& pattern) {
  factor_.assign(pattern.row.size(), Block::Zero());
  auto const count = pattern.first.size() - 1;
  work_.resize(count);
  waiting_.assign(count, last);
  next_.assign(count, last);
  reached_.resize(count);
}

template <int unknowns>
void BlockCholesky<unknowns>::factorize(FactorPattern const& pattern) {
  for (std::size_t column = 0; column < work_.size(); ++column) {
    auto const begin = at(pattern.first[column]), end = at(pattern.first[column + 1]);
    for (auto q = begin; q < end; ++q) work_[at(pattern.row[q])] = factor_[q];
    add_updates(pattern, column);
    eliminate(pattern, column);
    reached_[column] = pattern.first[column];
    queue(pattern, column);
  }
}

/// Takes off what the columns before take off this one.
template <int unknowns>
void BlockCholesky<unknowns>::add_updates(FactorPattern const& pattern, std::size_t column) {
  for (auto k = waiting_[column]; k != last;) {
    auto const other = at(k);
    k = next_[other];
    auto const begin = at(reached_[other]), end = at(pattern.first[other + 1]);
    Square const across = factor_[begin].template topRows<unknowns>();
    for (auto q = begin; q < end; ++q) {
      Block const& below = factor_[q];
      Block& to = work_[at(pattern.row[q])];
      for (int c = 0; c < unknowns; ++c)
        for (int a = 0; a < unknowns; ++a) to.col(c) -= across(c, a) * below.col(a);
    }
    queue(pattern, other);
  }
}

/// The block on the diagonal and those below, from the column at work.
template <int unknowns>
void BlockCholesky<unknowns>::eliminate(FactorPattern const& pattern, std::size_t column) {
  auto const begin = at(pattern.first[column]), end = at(pattern.first[column + 1]);
  Square lower = Square::Zero();
  double inverse[unknowns];  // of the diagonal
  for (int c = 0; c < unknowns; ++c)
    for (int r = c; r < unknowns; ++r) {
      double rest = work_[column](r, c);
      for (int a = 0; a < c; ++a) rest -= lower(r, a) * lower(c, a);
      lower(r, c) = r == c ? std::sqrt(rest) : rest * inverse[c];
      if (r == c) inverse[c] = 1 / lower(c, c);
    }
  factor_[begin].template topRows<unknowns>() = lower;
  for (auto q = begin + 1; q < end; ++q) {
    Block const& from = work_[at(pattern.row[q])];
    Block& to = factor_[q];
    for (int c = 0; c < unknowns; ++c) {
      Eigen::Matrix<double, rows, 1> rest = from.col(c);
      for (int a = 0; a < c; ++a) rest -= lower(c, a) * to.col(a);
      to.col(c) = inverse[c] * rest;
    }
  }
}

/// The column is next looked at for its next row.
template <int unknowns>
void BlockCholesky<unknowns>::queue(FactorPattern const& pattern, std::size_t column) {
  auto const place = ++reached_[column];
  if (place == pattern.first[column + 1]) return;
  auto const row = at(pattern.row[at(place)]);
  next_[column] = waiting_[row];
  waiting_[row] = static_cast<std::int32_t>(column);
}

template <int unknowns>
void BlockCholesky<unknowns>::solve(FactorPattern const& pattern, Eigen::VectorXd& b) const {
  auto const count = static_cast<std::int32_t>(work_.size());
  auto const part = [&](std::int32_t k) { return b.data() + unknowns * k; };
  for (std::int32_t k = 0; k < count; ++k) {
    auto const begin = at(pattern.first[at(k)]), end = at(pattern.first[at(k) + 1]);
    double* const x = part(k);
    for (int c = 0; c < unknowns; ++c) {
      x[c] /= factor_[begin](c, c);
      for (int r = c + 1; r < unknowns; ++r) x[r] -= factor_[begin](r, c) * x[c];
    }
    for (auto q = begin + 1; q < end; ++q) {
      double* const y = part(pattern.row[q]);
      for (int c = 0; c < unknowns; ++c)
        for (int r = 0; r < unknowns; ++r) y[r] -= factor_[q](r, c) * x[c];
    }
  }
  for (std::int32_t k = count; k-- > 0;) {
    auto const begin = at(pattern.first[at(k)]), end = at(pattern.first[at(k) + 1]);
    double* const x = part(k);
    for (auto q = begin + 1; q < end; ++q) {
      double const* const y = part(pattern.row[q]);
      for (int c = 0; c < unknowns; ++c)
        for (int r = 0; r < unknowns; ++r) x[c] -= factor_[q](r, c) * y[r];
    }
    for (int c = unknowns; c-- > 0;) {
      for (int r = c + 1; r < unknowns; ++r) x[c] -= factor_[begin](r, c) * x[r];
      x[c] /= factor_[begin](c, c);
    }
  }
}

template class BlockCholesky<2>;
template class BlockCholesky<3>;

}  // namespace bagnold::quasi_static
