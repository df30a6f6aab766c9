// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/engine/quasi_static/slope_between.hpp"

namespace bagnold::quasi_static {

namespace {

constexpr int most_iterations = 80, most_trials = 12;

/// Largest distance by which disks move while the factor keeps its normals, [d_s]. Rolling is
/// resisted by inertia alone, which at a rate of 1e-7 is 1e-8 of the resistance to overlaps.
/// Without spins damping resists sliding with k_t/(k_e h) of it; the distance is a share of that.
constexpr Real near = 1e-5, share_without_spins = 0.3, farthest_without_spins = 1e-3;

template <bool Rotates>
Real reach_of_factor(StepEquations<Rotates> const& equations) {
  if (Rotates) return near;
  Real const sliding = equations.tangential_damping() / equations.start().duration;
  return std::clamp(share_without_spins * sliding, near, farthest_without_spins);
}

/// A whole step is accepted if it leaves at most `good_share` of the residual; otherwise the slope
/// along it is reduced to `flat_share`. With good_share = 0.5, CD_rot at 1e-7 takes nearly twice as
/// many iterations (docs/data/performance/tried.md).
constexpr Real good_share = 0.1, flat_share = 0.2;

/// Trials along one Newton direction.
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

  /// Moves to `from + share direction` and returns the slope there.
  Real go(Real share) {
    u_ = from_ + share * direction_;
    equations_.keep_momentum(u_);
    equations_.evaluate(u_, false);
    ++counts_.evaluations;
    return equations_.residual().dot(direction_);
  }

  /// Searches from a whole step, with that slope, for a point where the slope is at most flat_share
  /// of that at the start. Most searches end where contacts close, which follows from the overlaps
  /// at both ends.
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
  Real const reach = reach_of_factor(equations);
  auto const is_near = [&] {
    return (u - of_factor).cwiseAbs().maxCoeff() * equations.start().duration < reach;
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
