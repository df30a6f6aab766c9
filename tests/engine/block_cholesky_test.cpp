// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/block_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "src/engine/quasi_static/rank_changes.hpp"
#include "src/engine/quasi_static/slope_between.hpp"

namespace bagnold::quasi_static {
namespace {

/// A random symmetric matrix of blocks, positive definite as its diagonal is large.
template <int unknowns>
struct BlockMatrix {
  std::vector<Entry> entries;
  Eigen::MatrixXd dense;

  BlockMatrix(std::int32_t columns, int pairs, std::mt19937& random)
      : dense(Eigen::MatrixXd::Zero(unknowns * columns, unknowns * columns)) {
    std::uniform_int_distribution<std::int32_t> any(0, columns - 1);
    while (static_cast<int>(entries.size()) < pairs) {
      auto const a = any(random), b = any(random);
      Entry const entry{std::max(a, b), std::min(a, b)};
      if (a == b || std::ranges::count(entries, entry) > 0) continue;
      entries.push_back(entry);
      Eigen::Matrix<double, unknowns, unknowns> const block =
          Eigen::Matrix<double, unknowns, unknowns>::Random();
      dense.block(unknowns * entry.row, unknowns * entry.column, unknowns, unknowns) = block;
      dense.block(unknowns * entry.column, unknowns * entry.row, unknowns, unknowns) =
          block.transpose();
    }
    Eigen::VectorXd const sums = dense.cwiseAbs().rowwise().sum();
    dense.diagonal() = sums.array() + 0.5;
  }
};

template <int unknowns>
void expect_dense_solution(std::int32_t columns, int pairs, std::mt19937& random) {
  BlockMatrix<unknowns> const matrix(columns, pairs, random);
  FactorPattern const pattern(columns, matrix.entries);
  BlockCholesky<unknowns> factor;
  for (int twice = 0; twice < 2; ++twice) {  // room of the first is used again
    factor.clear(pattern);
    auto const add = [&](Entry const& entry) {
      factor.add(pattern.find(entry), matrix.dense.template block<unknowns, unknowns>(
                                          unknowns * entry.row, unknowns * entry.column));
    };
    for (std::int32_t k = 0; k < columns; ++k) add({k, k});
    for (auto const& entry : matrix.entries) add(entry);
    factor.factorize(pattern);
    Eigen::VectorXd const b = Eigen::VectorXd::Random(unknowns * columns);
    Eigen::VectorXd x = b;
    factor.solve_lower(pattern, x);
    factor.solve_upper(pattern, x);
    EXPECT_LT((matrix.dense * x - b).cwiseAbs().maxCoeff(), 1e-13) << columns << " " << pairs;
  }
}

TEST(BlockCholesky, SolvesAsADenseMatrix) {
  std::mt19937 random(5);
  for (auto const& [columns, pairs] : {std::pair{1, 0}, {2, 1}, {5, 0}, {12, 20}, {40, 80}}) {
    expect_dense_solution<2>(columns, pairs, random);
    expect_dense_solution<3>(columns, pairs, random);
  }
}

/// Some pairs of columns held together, others let go by most of what held them.
TEST(RankChanges, SolveTheChangedMatrix) {
  std::mt19937 random(7);
  BlockMatrix<3> matrix(40, 80, random);
  FactorPattern const pattern(40, matrix.entries);
  BlockCholesky<3> factor;
  factor.clear(pattern);
  auto const add = [&](Entry const& entry) {
    factor.add(pattern.find(entry),
               matrix.dense.template block<3, 3>(3 * entry.row, 3 * entry.column));
  };
  for (std::int32_t k = 0; k < 40; ++k) add({k, k});
  for (auto const& entry : matrix.entries) add(entry);
  factor.factorize(pattern);

  RankChanges changes;
  for (std::uint32_t k = 0; k < 6; ++k) {
    Eigen::VectorXd w = Eigen::VectorXd::Zero(120);
    w[5 * k] = 0.6;
    w[5 * k + 60] = -0.8;
    double const amount = k % 2 == 0 ? 1e4 : -0.3;
    matrix.dense += amount * w * w.transpose();
    factor.solve_lower(pattern, w);
    changes.changes().push_back({k, amount, w});
  }
  changes.factorize();
  Eigen::VectorXd const b = Eigen::VectorXd::Random(120);
  Eigen::VectorXd x = b;
  factor.solve_lower(pattern, x);
  changes.correct(x);
  factor.solve_upper(pattern, x);
  EXPECT_LT((matrix.dense * x - b).cwiseAbs().maxCoeff(), 1e-10);
}

/// Springs that come into contact at 0.3 and out of it at 0.6 of the way, beside a linear rest.
TEST(SlopeBetween, FindsWhereItIsZero) {
  std::vector<NearPair> const pairs{{0, 1, {}, 1.0}, {1, 2, {}, 1.2}, {2, 3, {}, 1.0}};
  auto const overlaps = [](double part) {
    return std::vector<Real>{part - 0.3, 0.6 - part, 1 + part};
  };
  double const from = 0.5, to = 2.5, width = to - from;
  auto const slope = [&](double part) {
    return -0.2 + 0.1 * part + std::max(0.0, part - 0.3) / width -
           std::max(0.0, 0.6 - part) / (1.44 * width);
  };
  SlopeBetween const between({from, slope(0), overlaps(0)}, {to, slope(1), overlaps(1)}, pairs);
  EXPECT_NEAR(slope(between.zero()), 0, 1e-12);
}

/// Neighbouring columns with the same rows below are a group.
TEST(FactorPattern, GroupsColumns) {
  FactorPattern const dense(4, {{1, 0}, {2, 0}, {3, 0}});
  EXPECT_EQ(dense.group_end(0), 4u);
  FactorPattern const chain(4, {{1, 0}, {2, 1}, {3, 2}});
  EXPECT_EQ(chain.group_end(0), 1u);
  EXPECT_EQ(chain.group_end(2), 4u);
  FactorPattern const apart(3, {});
  EXPECT_EQ(apart.group_end(0), 1u);
}

/// Blocks of L that are not zero: of a chain none but its own, of a star that is eliminated from
/// its centre on all, from its ends on none but its own.
TEST(FactorPattern, HasWhatEliminationFillsIn) {
  EXPECT_EQ(FactorPattern(4, {{1, 0}, {2, 1}, {3, 2}}).row.size(), 4u + 3u);
  EXPECT_EQ(FactorPattern(4, {{1, 0}, {2, 0}, {3, 0}}).row.size(), 4u + 6u);
  EXPECT_EQ(FactorPattern(4, {{3, 0}, {3, 1}, {3, 2}}).row.size(), 4u + 3u);
}

}  // namespace
}  // namespace bagnold::quasi_static
