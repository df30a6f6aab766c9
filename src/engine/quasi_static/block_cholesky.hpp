// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/engine/quasi_static/factor_pattern.hpp"

namespace bagnold::quasi_static {

/// The factor L of a positive definite matrix L L^T of `unknowns` x `unknowns` blocks, one for each
/// disk and each pair that acts: column after column, each from those before it that reach into
/// its row. Blocks of 3 have a row of zeros below, so that a column fills a register.
template <int unknowns>
class BlockCholesky {
 public:
  static constexpr int rows = unknowns == 3 ? 4 : unknowns;
  using Block = Eigen::Matrix<double, rows, unknowns>;
  using Square = Eigen::Matrix<double, unknowns, unknowns>;

  /// Makes room for a matrix of this pattern, of zeros.
  void clear(FactorPattern const& pattern);

  /// A block of the matrix, by its place in pattern.row.
  void add(std::size_t place, Square const& block) {
    factor_[place].template topRows<unknowns>() += block;
  }

  /// Puts L in the place of the matrix.
  void factorize(FactorPattern const& pattern);

  /// Puts the x of L L^T x = b in the place of b.
  void solve(FactorPattern const& pattern, Eigen::VectorXd& b) const;

 private:
  void eliminate(FactorPattern const& pattern, std::size_t column);
  void add_updates(FactorPattern const& pattern, std::size_t column);
  void queue(FactorPattern const& pattern, std::size_t column);

  std::vector<Block> factor_;          ///< by pattern.row
  std::vector<Block> work_;            ///< [N] the column at work, by row
  std::vector<std::int32_t> waiting_;  ///< [N] first of the columns whose next row is this one
  std::vector<std::int32_t> next_;     ///< [N] the next one of them
  std::vector<std::int32_t> reached_;  ///< [N] place of a column's next row
};

}  // namespace bagnold::quasi_static
