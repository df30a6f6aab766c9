// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/engine/quasi_static/slope_between.hpp"

namespace bagnold::quasi_static {

namespace {

constexpr int most_iterations = 80, most_trials = 12;

/// Farthest that disks go while normals stay those of the factor, [d_s]: softest motions are
/// resisted by inertia alone, 1e-8 of what resists overlaps at a rate of 1e-7.
constexpr Real near = 1e-5;

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
        start_{0, equations.residual().dot(direction_), equations.overlap()} {}

  /// Goes to `from + share direction`; the slope there.
  Real go(Real share) {
    u_ = from_ + share * direction_;
    equations_.keep_momentum(u_);
    equations_.evaluate(u_, false);
    ++counts_.evaluations;
    return equations_.residual().dot(direction_);
  }

  /// From a whole step, with that slope, to where it is flat: flat_share of that at the start. Most
  /// ways end where contacts close, which are known from the overlaps at both ends.
  void search(Real at_end) {
    Trial low = start_, high{1, at_end, equations_.overlap()};
    Real slope = at_end;
    for (int k = 0; k < most_trials && std::abs(slope) > flat_share * std::abs(start_.slope); ++k) {
      if (k == 0 && slope < 0) return;  // still falling: the step is not too long
      Real const part = SlopeBetween(low, high, equations_.pairs()).zero();
      Real const share = low.share + part * (high.share - low.share);
      slope = go(share);
      (slope > 0 ? high : low) = Trial{share, slope, equations_.overlap()};
    }
  }

 private:
  StepEquations<Rotates>& equations_;
  SolveCounts& counts_;
  Eigen::VectorXd& u_;
  Eigen::VectorXd const from_, direction_;
  Trial const start_;
};

}  // namespace

template <bool Rotates>
bool solve_step(StepEquations<Rotates>& equations, NewtonMatrix<Rotates>& matrix, Real tolerance,
                Eigen::VectorXd& u, SolveCounts& counts) {
  u = equations.start().motion;
  equations.evaluate(u, true);
  ++counts.evaluations;
  Real left = equations.relative_residual();
  Eigen::VectorXd of_factor;  // the u that it belongs to
  auto const is_near = [&] {
    return (u - of_factor).cwiseAbs().maxCoeff() * equations.start().duration < near;
  };
  for (int k = 0; k < most_iterations && (k == 0 || left > tolerance); ++k) {
    ++counts.iterations;
    if (k == 0 || !is_near() || !matrix.update(equations.active())) {
      matrix.factorize(equations.inertia(), equations.active());
      ++counts.factorizations;
      of_factor = u;
    }
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
