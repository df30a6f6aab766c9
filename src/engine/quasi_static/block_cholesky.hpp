// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/engine/quasi_static/factor_pattern.hpp"

namespace bagnold::quasi_static {

/// Factor L of a positive definite matrix L L^T of `unknowns` x `unknowns` blocks, one for each
/// disk and each pair that acts. It is computed column by column, each from the earlier ones that
/// reach into its row, three of a group at a time, so that the column is read and written once for
/// the three. Blocks of 3 have a row of zeros below, so that a column fills a register.
template <int unknowns>
class BlockCholesky {
 public:
  static constexpr int rows = unknowns == 3 ? 4 : unknowns;
  using Block = Eigen::Matrix<double, rows, unknowns>;
  using Square = Eigen::Matrix<double, unknowns, unknowns>;

  /// Allocates a zero matrix of this pattern.
  void clear(FactorPattern const& pattern);

  /// Adds a block of the matrix, by its place in pattern.row.
  void add(std::size_t place, Square const& block) {
    factor_[place].template topRows<unknowns>() += block;
  }

  /// Replaces the matrix by L.
  void factorize(FactorPattern const& pattern);

  /// Replaces b by the solution x of L x = b, or of L^T x = b.
  void solve_lower(FactorPattern const& pattern, Eigen::VectorXd& b) const;
  void solve_upper(FactorPattern const& pattern, Eigen::VectorXd& b) const;

 private:
  void eliminate(FactorPattern const& pattern, std::size_t column);
  void take_off(FactorPattern const& pattern, std::size_t begin, std::size_t end, std::size_t rows);
  template <int columns>
  void take_off(FactorPattern const& pattern, std::size_t column, std::size_t count);
  void queue(FactorPattern const& pattern, std::size_t group, std::size_t rows);

  std::vector<Block> factor_;          ///< by pattern.row
  std::vector<Block> work_;            ///< [N] the column at work, by row
  std::vector<std::int32_t> waiting_;  ///< [N] first of the groups whose next row is this one
  std::vector<std::int32_t> next_;     ///< [N] the next one of them
  std::vector<std::size_t> left_;      ///< [N] rows of a group from its next one on
};

}  // namespace bagnold::quasi_static
