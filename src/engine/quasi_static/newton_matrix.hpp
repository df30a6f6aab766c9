// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "src/engine/quasi_static/block_cholesky.hpp"
#include "src/engine/quasi_static/rank_changes.hpp"
#include "src/engine/quasi_static/step_equations.hpp"

namespace bagnold::quasi_static {

/// Matrix of Newton's iteration, M + h C + h^2 K, and its factor: C the damping of the pairs that
/// act, K the stiffness of those that touch along their normals. The rotation of the normals
/// (prestress) is left out: with it the matrix would not be positive definite at first guesses.
template <bool Rotates>
class NewtonMatrix {
 public:
  static constexpr int unknowns = StepEquations<Rotates>::unknowns;

  /// Chooses the order in which disks are eliminated, for contacts of these pairs (approximate
  /// minimum degree). It depends on nothing else.
  void order(std::uint32_t disks, std::vector<NearPair> const& contacts);

  void factorize(Eigen::VectorXd const& inertia, std::vector<ActivePair> const& active);

  /// Includes contacts that have opened or closed in the step since the factorization, without a
  /// new factor; all else stays unchanged, normals too. A contact ij changes the matrix by
  ///
  ///     +-(h^2 k + h k_n) w w^T,   w = n of disk i, -n of disk j
  ///
  /// Returns whether they are few enough; otherwise nothing is done.
  bool update(std::vector<ActivePair> const& active);

  /// Solution u of matrix u = right.
  Eigen::VectorXd solve(Eigen::VectorXd const& right) const;

 private:
  void lay_out(std::vector<ActivePair> const& active);
  Eigen::VectorXd column_of(ActivePair const& pair) const;

  std::vector<std::int32_t> place_;  ///< of each disk in the order
  std::vector<Entry> entries_;       ///< of each pair that acts
  FactorPattern pattern_;            ///< of these, kept where they are the same again
  BlockCholesky<unknowns> factor_;
  std::vector<ActivePair> factorized_;  ///< the pairs it was made of
  RankChanges since_;                   ///< what changed since
};

}  // namespace bagnold::quasi_static
