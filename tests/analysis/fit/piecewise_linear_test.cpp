// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/piecewise_linear.hpp"

#include <Eigen/QR>

#include "src/config/errors.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

double two_kinks(double x) {
  return 1.0 + 20.0 * x + 700.0 * std::max(0.0, x - 0.7923) - 650.0 * std::max(0.0, x - 0.8061);
}
double one_kink(double x) { return 3.0 - 2.0 * x + 9.0 * std::max(0.0, x - 4.37); }

/// chi2 with breaks held where they are: plain linear least squares.
double chi2_at(Points const& points, std::vector<double> const& breaks) {
  auto const n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd design(n, 2 + static_cast<Eigen::Index>(breaks.size()));
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    auto const row = static_cast<std::size_t>(i);
    double const w = 1.0 / points.error[row];
    design(i, 0) = w;
    design(i, 1) = w * points.x[row];
    for (std::size_t k = 0; k < breaks.size(); ++k)
      design(i, 2 + static_cast<Eigen::Index>(k)) = w * std::max(0.0, points.x[row] - breaks[k]);
    y[i] = w * points.y[row];
  }
  return (y - design * design.colPivHouseholderQr().solve(y)).squaredNorm();
}

TEST(PiecewiseLinear, FindsKinksOfExactPoints) {
  auto const error = [](double) { return 0.01; };
  auto const one = fit_piecewise_linear(sampled(evenly(0, 10, 15), one_kink, error, nullptr), 1);
  EXPECT_NEAR(one.value[3], 4.37, 1e-9);
  EXPECT_NEAR(one.value[2], 9.0, 1e-9);
  auto const two =
      fit_piecewise_linear(sampled(evenly(0.77, 0.82, 26), two_kinks, error, nullptr), 2);
  EXPECT_NEAR(two.value[3], 0.7923, 1e-8);
  EXPECT_NEAR(two.value[5], 0.8061, 1e-8);
  EXPECT_NEAR(piecewise_linear(0.81, two.value), two_kinks(0.81), 1e-8);
}

/// No place of the breaks on a fine grid gives a lower chi2.
TEST(PiecewiseLinear, IsTheBestOfAll) {
  std::mt19937_64 random(10);
  auto const error = [](double) { return 2.0; };
  for (int set = 0; set < 30; ++set) {
    auto const one = sampled(evenly(0, 10, 9), one_kink, error, &random);
    double least = INFINITY;
    for (double const x : evenly(1.26, 8.74, 600)) least = std::min(least, chi2_at(one, {x}));
    EXPECT_LE(fit_piecewise_linear(one, 1).chi2, least * (1 + 1e-9)) << set;
  }
  auto const coarse = [](double) { return 1.0; };
  for (int set = 0; set < 3; ++set) {
    auto const two = sampled(evenly(0.77, 0.82, 12), two_kinks, coarse, &random);
    double least = INFINITY;
    auto const places = evenly(0.7747, 0.8153, 120);
    // two points at least between the breaks, as promised
    double const apart = 2.0 * 0.05 / 11.0;
    for (double const x : places)
      for (double const y : places)
        if (y > x + apart) least = std::min(least, chi2_at(two, {x, y}));
    EXPECT_LE(fit_piecewise_linear(two, 2).chi2, least * (1 + 1e-9)) << set;
  }
}

TEST(PiecewiseLinear, ErrorsAreRight) {
  std::mt19937_64 random(11);
  Pulls one, first, second;
  for (int set = 0; set < 1000; ++set) {
    auto const a =
        fit_piecewise_linear(sampled(
                                 evenly(0, 10, 22), one_kink, [](double) { return 0.4; }, &random),
                             1);
    one.add(a.value[3], 4.37, a.error[3]);
    auto const b = fit_piecewise_linear(
        sampled(
            evenly(0.77, 0.82, 26), two_kinks, [](double) { return 0.05; }, &random),
        2);
    first.add(b.value[3], 0.7923, b.error[3]);
    second.add(b.value[5], 0.8061, b.error[5]);
  }
  for (auto const* pulls : {&one, &first, &second}) pulls->expect_right(0.05);
}

TEST(PiecewiseLinear, FewerKinksThanAskedFor) {
  auto const says = [](Points const& points, std::size_t breaks, std::string const& text) {
    try {
      fit_piecewise_linear(points, breaks);
      ADD_FAILURE() << "accepted; expected: " << text;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  auto const error = [](double) { return 0.01; };
  for (double const slope : {0.0, 3.0}) {
    auto const line = [&](double x) { return 2.0 + slope * x; };
    auto const straight = sampled(evenly(0.7, 0.8, 11), line, error, nullptr);
    says(straight, 1, "no kink: the points lie on a straight line");
    says(straight, 2, "no second kink");
  }
  says(sampled(evenly(0, 10, 21), one_kink, error, nullptr), 2, "give --kinks 1");
}

TEST(PiecewiseLinear, BadInput) {
  EXPECT_THROW(fit_piecewise_linear({{1, 2, 3}, {1, 2, 3}, {}}, 1), InputError);
  EXPECT_THROW(fit_piecewise_linear({{1, 2, 2, 3, 4}, {1, 2, 3, 4, 5}, {}}, 1), InputError);
  EXPECT_THROW(fit_piecewise_linear({{1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}, {}}, 3), InputError);
}

}  // namespace
}  // namespace bagnold::analysis
