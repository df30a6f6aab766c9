// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstdint>
#include <vector>

#include "kernels/physics/vec2.hpp"

namespace bagnold::quasi_static {

/// A change c w w^T of a factorized matrix L L^T.
struct RankChange {
  std::uint32_t pair;      ///< of the list, whose contact opened or closed
  Real amount;             ///< c
  Eigen::VectorXd column;  ///< L^-1 w
};

/// A few changes of a matrix, without a new factor (Sherman, Morrison, Woodbury):
///
///     (L L^T + W C W^T)^-1 = L^-T [1 - Y (C^-1 + Y^T Y)^-1 Y^T] L^-1,   Y = L^-1 W
class RankChanges {
 public:
  void clear() { changes_.clear(); }

  std::vector<RankChange>& changes() { return changes_; }

  /// Factorizes the inner matrix, after all changes have been added.
  void factorize() {
    auto const count = static_cast<Eigen::Index>(changes_.size());
    Eigen::MatrixXd inner(count, count);
    for (Eigen::Index a = 0; a < count; ++a)
      for (Eigen::Index b = 0; b <= a; ++b)
        inner(a, b) = inner(b, a) =
            of(a).column.dot(of(b).column) + (a == b ? 1 / of(a).amount : 0);
    if (count > 0) inner_.compute(inner);
  }

  /// Applies the factor between L^-T and L^-1 to x.
  void correct(Eigen::VectorXd& x) const {
    if (changes_.empty()) return;
    auto const count = static_cast<Eigen::Index>(changes_.size());
    Eigen::VectorXd along(count);
    for (Eigen::Index a = 0; a < count; ++a) along[a] = of(a).column.dot(x);
    along = inner_.solve(along).eval();
    for (Eigen::Index a = 0; a < count; ++a) x -= along[a] * of(a).column;
  }

 private:
  RankChange const& of(Eigen::Index a) const { return changes_[static_cast<std::size_t>(a)]; }

  std::vector<RankChange> changes_;
  Eigen::PartialPivLU<Eigen::MatrixXd> inner_;  ///< of C^-1 + Y^T Y
};

}  // namespace bagnold::quasi_static
