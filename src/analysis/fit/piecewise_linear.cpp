// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/piecewise_linear.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "src/analysis/fit/covariance.hpp"
#include "src/analysis/fit/weights.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

/// Possible place of a break: in the gap after a point, or on the point itself.
struct Place {
  std::size_t point;
  bool in_gap;
};

class Search {
 public:
  /// Tries all choices of so many breaks.
  Search(Points const& points, std::size_t breaks)
      : points_(points), weight_(weights(points)), y_(weighted_values(points)) {
    std::vector<Place> places;
    place(places, breaks);
  }

  Fit best() const { return best_; }
  bool found() const { return !best_.value.empty(); }

  /// Whether the best one holds all points to rounding, in the mean square.
  bool is_exact() const {
    constexpr double rounding = 1e-11;
    return found() && best_.chi2 <= rounding * rounding * y_.squaredNorm();
  }

 private:
  /// Tries all choices of `more` further breaks beyond those placed.
  void place(std::vector<Place>& places, std::size_t more) {
    if (more == 0) return attempt(places);
    auto const n = points_.size();
    // two points at least on the left, between two breaks, and on the right; one on a break counts
    // for both sides
    std::size_t const first =
        places.empty() ? 1 : places.back().point + (places.back().in_gap ? 2 : 1);
    for (auto point = first; point + 1 < n; ++point)
      for (bool const in_gap : {true, false}) {
        if (in_gap && point + 2 >= n) continue;
        places.push_back({point, in_gap});
        place(places, more - 1);
        places.pop_back();
      }
  }

  void attempt(std::vector<Place> const& places) {
    auto const n = static_cast<Eigen::Index>(points_.size());
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(n, columns(places));
    for (Eigen::Index i = 0; i < n; ++i) {
      double const x = points_.x[static_cast<std::size_t>(i)];
      Eigen::Index column = 0;
      design(i, column++) = weight_[i];
      design(i, column++) = weight_[i] * x;
      for (auto const& place : places) {
        double const start = points_.x[place.point];
        bool const beyond = static_cast<std::size_t>(i) > place.point;
        design(i, column++) = beyond ? weight_[i] * (x - start) : 0.0;
        if (place.in_gap) design(i, column++) = beyond ? weight_[i] : 0.0;
      }
    }
    Eigen::VectorXd const solved = design.householderQr().solve(y_);
    double const chi2 = (y_ - design * solved).squaredNorm();
    if (!(chi2 < best_chi2())) return;
    std::vector<double> value{solved[0], solved[1]};
    Eigen::Index column = 2;
    for (auto const& place : places) {
      double const start = points_.x[place.point], bend = solved[column++];
      double const step = place.in_gap ? solved[column++] : 0.0;
      double const where = place.in_gap ? start - step / bend : start;
      if (place.in_gap && !(where > start && where < points_.x[place.point + 1])) return;
      value.insert(value.end(), {bend, where});
    }
    best_.value = value;
    best_.chi2 = chi2;
  }

  static Eigen::Index columns(std::vector<Place> const& places) {
    return 2 + static_cast<Eigen::Index>(places.size()) +
           std::ranges::count_if(places, [](auto const& place) { return place.in_gap; });
  }
  double best_chi2() const {
    return found() ? best_.chi2 : std::numeric_limits<double>::infinity();
  }

  Points const& points_;
  Eigen::VectorXd weight_, y_;
  Fit best_;
};

/// Throws InputError where one break less is exact to rounding: a further one would bend by
/// nothing.
void refuse_straight(Points const& points, std::size_t breaks) {
  if (Search(points, breaks - 1).is_exact())
    throw InputError(fmt::format("piecewise linear fit: no {}",
                                 breaks > 1
                                     ? "second kink: two straight lines are exact; give --kinks 1"
                                     : "kink: the points lie on a straight line"));
}

/// Jacobian with respect to {a, b, c_k, x_k}, weighted.
Eigen::MatrixXd jacobian(Points const& points, std::vector<double> const& value) {
  auto const weight = weights(points);
  auto const n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd out(n, static_cast<Eigen::Index>(value.size()));
  for (Eigen::Index i = 0; i < n; ++i) {
    double const x = points.x[static_cast<std::size_t>(i)];
    out(i, 0) = 1.0;
    out(i, 1) = x;
    for (std::size_t k = 2; k < value.size(); k += 2) {
      auto const column = static_cast<Eigen::Index>(k);
      out(i, column) = std::max(0.0, x - value[k + 1]);
      out(i, column + 1) = x > value[k + 1] ? -value[k] : 0.0;
    }
    out.row(i) *= weight[i];
  }
  return out;
}

}  // namespace

double piecewise_linear(double x, std::vector<double> const& value) {
  double y = value[0] + value[1] * x;
  for (std::size_t k = 2; k < value.size(); k += 2) y += value[k] * std::max(0.0, x - value[k + 1]);
  return y;
}

Fit fit_piecewise_linear(Points const& points, std::size_t breaks) {
  if (breaks != 1 && breaks != 2)
    throw InputError(fmt::format("--kinks {} (must be 1 or 2)", breaks));
  check_points(points, 2 + 2 * breaks, "piecewise linear fit");
  check_distinct(points, "piecewise linear fit");
  refuse_straight(points, breaks);
  Search const search(points, breaks);
  if (!search.found()) throw InputError("piecewise linear fit: no kink between the points");
  Fit out = search.best();
  out.freedom = points.size() - out.value.size();
  set_covariance(out, jacobian(points, out.value), points.weighted());
  return out;
}

}  // namespace bagnold::analysis
