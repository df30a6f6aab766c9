// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/analysis/fit/covariance.hpp"
#include "src/analysis/fit/least_squares.hpp"
#include "src/analysis/fit/weights.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

constexpr std::ptrdiff_t fewest_on_branch = 3, fewest_between = 2;

/// A curve of kinks at given places, without its coefficients.
struct Shape {
  std::vector<double> kinks;
  std::size_t left, right;

  std::size_t columns() const { return kinks.size() + left + right; }

  /// d y / d coefficient, in the order {a, b, c_k, l_j, r_j}.
  Eigen::RowVectorXd basis(double x) const {
    Eigen::RowVectorXd out(static_cast<Eigen::Index>(columns()));
    Eigen::Index at = 0;
    out[at++] = 1.0;
    out[at++] = x;
    for (double const kink : kinks) out[at++] = std::max(0.0, x - kink);
    for (std::size_t j = 2; j <= left; ++j)
      out[at++] = std::pow(std::min(0.0, x - kinks.front()), static_cast<double>(j));
    for (std::size_t j = 2; j <= right; ++j)
      out[at++] = std::pow(std::max(0.0, x - kinks.back()), static_cast<double>(j));
    return out;
  }
};

class Search {
 public:
  Search(Points const& points, std::size_t left_degree, std::size_t right_degree)
      : points_(points),
        left_(left_degree),
        right_(right_degree),
        weight_(weights(points)),
        y_(weighted_values(points)) {}

  /// Shape with kinks at given places; none where a branch, or the part between the kinks, has too
  /// few points.
  std::optional<Shape> shape(std::vector<double> const& kinks) const {
    auto const& x = points_.x;
    auto const left = std::ranges::upper_bound(x, kinks.front()) - x.begin();
    auto const right = x.end() - std::ranges::lower_bound(x, kinks.back());
    auto const between =
        std::ranges::lower_bound(x, kinks.back()) - std::ranges::upper_bound(x, kinks.front());
    if (left < fewest_on_branch || right < fewest_on_branch ||
        (kinks.size() > 1 && between < fewest_between))
      return std::nullopt;
    auto const degree = [](std::size_t wanted, std::ptrdiff_t count) {
      return std::min(wanted, static_cast<std::size_t>(count - 1));
    };
    return Shape{kinks, degree(left_, left), degree(right_, right)};
  }

  Solution solve(Shape const& shape) const {
    Eigen::MatrixXd design(static_cast<Eigen::Index>(points_.size()),
                           static_cast<Eigen::Index>(shape.columns()));
    for (Eigen::Index i = 0; i < design.rows(); ++i)
      design.row(i) = weight_[i] * shape.basis(points_.x[static_cast<std::size_t>(i)]);
    return least_squares(design, y_);
  }

  double chi2(std::vector<double> const& kinks) const {
    auto const found = shape(kinks);
    return found ? solve(*found).chi2 : INFINITY;
  }

  /// Candidates for places of kinks: on points and midway between them.
  std::vector<double> candidates() const {
    std::vector<double> out;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      out.push_back(points_.x[i]);
      if (i + 1 < points_.size()) out.push_back((points_.x[i] + points_.x[i + 1]) / 2.0);
    }
    return out;
  }

  std::vector<double> best(std::size_t kinks) const {
    auto const places = candidates();
    std::vector<double> best;
    double least = INFINITY;
    auto const attempt = [&](std::vector<double> const& now) {
      if (double const value = chi2(now); value < least) least = value, best = now;
    };
    for (std::size_t i = 0; i < places.size(); ++i)
      if (kinks == 1)
        attempt({places[i]});
      else
        for (auto j = i + 1; j < places.size(); ++j) attempt({places[i], places[j]});
    if (best.empty()) throw InputError("kinks between curved branches: too few points");
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
      for (double& kink : best) improve(best, kink, places);
    return best;
  }

 private:
  /// Moves one kink to the least chi2 between the candidates beside it.
  void improve(std::vector<double>& kinks, double& kink, std::vector<double> const& places) const {
    auto const at = std::ranges::lower_bound(places, kink);
    double low = at == places.begin() ? kink : *(at - 1);
    double high = at == places.end() || at + 1 == places.end() ? kink
                  : *at > kink                                 ? *at
                                                               : *(at + 1);
    double const start = kink, before = chi2(kinks), share = (std::sqrt(5.0) - 1.0) / 2.0;
    auto const value = [&](double x) {
      kink = x;
      return chi2(kinks);
    };
    double x1 = high - share * (high - low), x2 = low + share * (high - low);
    double y1 = value(x1), y2 = value(x2);
    constexpr int sections = 24;  // of the interval, to 1e-5 of it
    for (int i = 0; i < sections; ++i)
      if (y1 < y2) {
        high = x2, x2 = x1, y2 = y1;
        x1 = high - share * (high - low), y1 = value(x1);
      } else {
        low = x1, x1 = x2, y1 = y2;
        x2 = low + share * (high - low), y2 = value(x2);
      }
    if (value((low + high) / 2.0) > before) kink = start;
  }

  Points const& points_;
  std::size_t left_, right_;
  Eigen::VectorXd weight_, y_;
};

/// {a, b, c_1, x_1, ..., l_j, r_j} of coefficients {a, b, c_k, l_j, r_j} and places.
std::vector<double> values_of(Shape const& shape, Eigen::VectorXd const& solved) {
  std::vector<double> out{solved[0], solved[1]};
  Eigen::Index at = 2;
  for (double const kink : shape.kinks) out.insert(out.end(), {solved[at++], kink});
  while (at < solved.size()) out.push_back(solved[at++]);
  return out;
}

/// Jacobian of values_of, weighted.
Eigen::MatrixXd jacobian(Points const& points, Shape const& shape, Eigen::VectorXd const& solved) {
  auto const weight = weights(points);
  auto const n = static_cast<Eigen::Index>(shape.kinks.size());
  Eigen::MatrixXd out(static_cast<Eigen::Index>(points.size()), solved.size() + n);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    double const x = points.x[static_cast<std::size_t>(i)];
    auto const basis = shape.basis(x);
    out(i, 0) = basis[0];
    out(i, 1) = basis[1];
    for (Eigen::Index k = 0; k < n; ++k) {
      out(i, 2 + 2 * k) = basis[2 + k];
      out(i, 3 + 2 * k) = x > shape.kinks[static_cast<std::size_t>(k)] ? -solved[2 + k] : 0.0;
    }
    Eigen::Index at = 2 + n;
    auto const branch = [&](std::size_t degree, double beyond, Eigen::Index kink) {
      for (std::size_t j = 2; j <= degree; ++j, ++at) {
        auto const power = static_cast<double>(j);
        out(i, at + n) = basis[at];
        out(i, 3 + 2 * kink) -= solved[at] * power * std::pow(beyond, power - 1.0);
      }
    };
    branch(shape.left, std::min(0.0, x - shape.kinks.front()), 0);
    branch(shape.right, std::max(0.0, x - shape.kinks.back()), n - 1);
    out.row(i) *= weight[i];
  }
  return out;
}

}  // namespace

double Branches::operator()(double x) const {
  Shape shape{{}, left, right};
  Eigen::VectorXd solved(static_cast<Eigen::Index>(fit.value.size() - kinks));
  solved[0] = fit.value[0];
  solved[1] = fit.value[1];
  Eigen::Index at = 2;
  for (std::size_t k = 0; k < kinks; ++k) {
    shape.kinks.push_back(place(k));
    solved[at++] = bend(k);
  }
  for (auto k = 2 + 2 * kinks; k < fit.value.size(); ++k) solved[at++] = fit.value[k];
  return shape.basis(x).dot(solved);
}

Branches fit_branches(Points const& points, std::size_t kinks, std::size_t left_degree,
                      std::size_t right_degree) {
  if (kinks != 1 && kinks != 2) throw InputError(fmt::format("--kinks {} (must be 1 or 2)", kinks));
  check_points(points, 2 * kinks + left_degree + right_degree, "kinks between curved branches");
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points.x[i] > points.x[i - 1]))
      throw InputError(fmt::format(
          "kinks between curved branches: two points at x = {}; tell them apart with --by",
          points.x[i]));
  Search const search(points, left_degree, right_degree);
  auto const shape = *search.shape(search.best(kinks));
  auto const solution = search.solve(shape);
  Branches out{{}, kinks, shape.left, shape.right};
  out.fit.value = values_of(shape, solution.value);
  out.fit.chi2 = solution.chi2;
  out.fit.freedom = points.size() - out.fit.value.size();
  set_covariance(out.fit, jacobian(points, shape, solution.value), points.weighted());
  return out;
}

Fit fit_polynomial(Points const& points, std::size_t parameters) {
  check_points(points, parameters, "polynomial");
  auto const [low, high] = std::ranges::minmax(points.x);
  auto const weight = weights(points);
  Eigen::MatrixXd design(static_cast<Eigen::Index>(points.size()),
                         static_cast<Eigen::Index>(parameters));
  for (Eigen::Index i = 0; i < design.rows(); ++i) {
    double const u = 2.0 * (points.x[static_cast<std::size_t>(i)] - low) / (high - low) - 1.0;
    for (Eigen::Index j = 0; j < design.cols(); ++j)
      design(i, j) = weight[i] * std::cos(static_cast<double>(j) * std::acos(u));
  }
  auto const solution = least_squares(design, weighted_values(points));
  Fit out;
  out.value.assign(solution.value.begin(), solution.value.end());
  out.chi2 = solution.chi2;
  out.freedom = points.size() - parameters;
  set_covariance(out, design, points.weighted());
  return out;
}

}  // namespace bagnold::analysis
