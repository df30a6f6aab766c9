// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bagnold::quasi_static {

namespace {

constexpr int most_iterations = 40, most_trials = 12;

/// A whole step is taken as it is where it leaves no more than `good_share` of the residual; else
/// the slope along it is brought down to `flat_share`. With a half for the first, CD_rot at 1e-7
/// takes nearly twice as many iterations (docs/performance_log.md).
constexpr Real good_share = 0.1, flat_share = 0.2;

/// Trials along one direction of Newton.
template <bool Rotates>
class Line {
 public:
  Line(StepEquations<Rotates>& equations, SolveCounts& counts, Eigen::VectorXd& u,
       Eigen::VectorXd direction)
      : equations_(equations),
        counts_(counts),
        u_(u),
        from_(u),
        direction_(std::move(direction)),
        slope_(equations.residual().dot(direction_)) {}

  /// Goes to `from + share direction`; the slope there.
  Real go(Real share) {
    u_ = from_ + share * direction_;
    equations_.keep_momentum(u_);
    equations_.evaluate(u_, false);
    ++counts_.evaluations;
    return equations_.residual().dot(direction_);
  }

  /// From a whole step, with that slope, to where it is flat: flat_share of that at the start.
  void search(Real at_end) {
    Real low = 0, at_low = slope_, high = 1, at_high = at_end, slope = at_end;
    for (int k = 0; k < most_trials && std::abs(slope) > flat_share * std::abs(slope_); ++k) {
      if (k == 0 && slope < 0) return;  // still falling: the step is not too long
      Real const share =
          low + (high - low) * std::clamp(at_low / (at_low - at_high), Real(0.1), Real(0.9));
      slope = go(share);
      if (slope > 0) {
        high = share;
        at_high = slope;
      } else {
        low = share;
        at_low = slope;
      }
    }
  }

 private:
  StepEquations<Rotates>& equations_;
  SolveCounts& counts_;
  Eigen::VectorXd& u_;
  Eigen::VectorXd const from_, direction_;
  Real const slope_;
};

}  // namespace

template <bool Rotates>
bool solve_step(StepEquations<Rotates>& equations, NewtonMatrix<Rotates>& matrix, Real tolerance,
                Eigen::VectorXd& u, SolveCounts& counts) {
  u = equations.start().motion;
  equations.evaluate(u, true);
  ++counts.evaluations;
  Real left = equations.relative_residual();
  for (int k = 0; k < most_iterations && (k == 0 || left > tolerance); ++k) {
    matrix.factorize(equations.inertia(), equations.active());
    ++counts.iterations;
    Line<Rotates> line(equations, counts, u, matrix.solve(-equations.residual()));
    Real const slope = line.go(1);
    Real const before = left;
    left = equations.relative_residual();
    if (k > 0 && !(left <= good_share * before)) {
      line.search(slope);
      left = equations.relative_residual();
    }
    if (!std::isfinite(left)) return false;
  }
  return left <= tolerance;
}

template bool solve_step(StepEquations<false>&, NewtonMatrix<false>&, Real, Eigen::VectorXd&,
                         SolveCounts&);
template bool solve_step(StepEquations<true>&, NewtonMatrix<true>&, Real, Eigen::VectorXd&,
                         SolveCounts&);

}  // namespace bagnold::quasi_static
