// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/block_cholesky.hpp"

#include <algorithm>
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
  left_.resize(count);
}

template <int unknowns>
void BlockCholesky<unknowns>::factorize(FactorPattern const& pattern) {
  std::size_t begin = 0;  // of the group
  for (std::size_t column = 0; column < work_.size(); ++column) {
    auto const from = at(pattern.first[column]), to = at(pattern.first[column + 1]);
    for (auto q = from; q < to; ++q) work_[at(pattern.row[q])] = factor_[q];
    for (auto k = waiting_[column]; k != last;) {
      auto const group = at(k);
      k = next_[group];
      take_off(pattern, group, pattern.group_end(group), left_[group]);
      queue(pattern, group, left_[group] - 1);
    }
    take_off(pattern, begin, column, to - from);
    eliminate(pattern, column);
    if (pattern.last_of_group[column]) {
      queue(pattern, begin, to - from - 1);
      begin = column + 1;
    }
  }
}

/// Subtracts from the present column the contributions of the columns of an earlier group, whose
/// last `rows` rows begin with the present one.
template <int unknowns>
void BlockCholesky<unknowns>::take_off(FactorPattern const& pattern, std::size_t begin,
                                       std::size_t end, std::size_t rows) {
  for (; end - begin >= 3; begin += 3) take_off<3>(pattern, begin, rows);
  if (end - begin == 2) take_off<2>(pattern, begin, rows);
  if (end - begin == 1) take_off<1>(pattern, begin, rows);
}

template <int unknowns>
template <int columns>
void BlockCholesky<unknowns>::take_off(FactorPattern const& pattern, std::size_t column,
                                       std::size_t count) {
  Block const* below[columns];
  Square across[columns];
  for (int k = 0; k < columns; ++k) {
    below[k] = factor_.data() + at(pattern.first[column + k + 1]) - count;
    across[k] = below[k]->template topRows<unknowns>();
  }
  auto const* row = pattern.row.data() + at(pattern.first[column + 1]) - count;
  for (std::size_t q = 0; q < count; ++q) {
    Block& to = work_[at(row[q])];
    for (int c = 0; c < unknowns; ++c) {
      Eigen::Matrix<double, rows, 1> rest = to.col(c);
      for (int k = 0; k < columns; ++k)
        for (int a = 0; a < unknowns; ++a) rest -= across[k](c, a) * below[k][q].col(a);
      to.col(c) = rest;
    }
  }
}

/// Computes the block on the diagonal and those below it from the present column.
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

/// Queues a group for the column of the first of its last `rows` rows.
template <int unknowns>
void BlockCholesky<unknowns>::queue(FactorPattern const& pattern, std::size_t group,
                                    std::size_t rows) {
  left_[group] = rows;
  if (rows == 0) return;
  auto const row = at(pattern.row[at(pattern.first[group + 1]) - rows]);
  next_[group] = waiting_[row];
  waiting_[row] = static_cast<std::int32_t>(group);
}

template <int unknowns>
void BlockCholesky<unknowns>::solve_lower(FactorPattern const& pattern, Eigen::VectorXd& b) const {
  auto const count = static_cast<std::int32_t>(work_.size());
  auto const part = [&](std::int32_t k) { return b.data() + unknowns * k; };
  for (std::int32_t k = 0; k < count; ++k) {
    auto const begin = at(pattern.first[at(k)]), end = at(pattern.first[at(k) + 1]);
    double* const x = part(k);
    if (std::all_of(x, x + unknowns, [](double c) { return c == 0; })) continue;
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
}

template <int unknowns>
void BlockCholesky<unknowns>::solve_upper(FactorPattern const& pattern, Eigen::VectorXd& b) const {
  auto const part = [&](std::int32_t k) { return b.data() + unknowns * k; };
  for (auto k = static_cast<std::int32_t>(work_.size()); k-- > 0;) {
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
