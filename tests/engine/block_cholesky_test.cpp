// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/block_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

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
