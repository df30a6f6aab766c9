// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/levenberg_marquardt.hpp"

#include "src/config/errors.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

/// A model with known parameters, sampled where the papers did.
struct Case {
  char const* name;
  std::function<Model(Points const&)> model;
  std::function<double(double)> curve;  ///< written out here, not taken from the model
  std::vector<double> x, truth;
  Fixed fixed;
  double noise;  ///< relative
};

std::vector<Case> cases() {
  auto const crossover = [](double q) {
    return 40.0 * std::pow(1.0 + std::pow(q / 7.35, 3.0), 1.3 / 3.0);
  };
  auto const divergence = [](double phi) { return 1.89 + 0.05 * std::pow(0.84335 - phi, -1.65); };
  auto const law = [](double i) { return 0.093 + 0.6 * std::pow(i, 0.46); };
  auto const phi = evenly(0.60, 0.835, 14);
  auto const friction = [](Points const&) { return friction_law_model(); };
  auto const numbers = geometric(1e-4, 1e-1, 16);
  return {
      {"crossover",
       crossover_model,
       crossover,
       geometric(0.1, 500, 20),
       {40, 7.35, 3, 1.3},
       {},
       0.02},
      {"crossover, s fixed",
       crossover_model,
       crossover,
       geometric(0.1, 500, 20),
       {40, 7.35, 3, 1.3},
       {{"s", 3.0}},
       0.02},
      {"divergence",
       divergence_model,
       divergence,
       phi,
       {1.89, 0.05, 0.84335, 1.65},
       {{"phi_J", 0.84335}},
       0.01},
      {"divergence, phi_J free",
       divergence_model,
       divergence,
       phi,
       {1.89, 0.05, 0.84335, 1.65},
       {},
       0.003},
      {"friction law", friction, law, numbers, {0.093, 0.6, 0.46}, {}, 0.005},
      {"friction law, mu_J fixed",
       friction,
       law,
       numbers,
       {0.093, 0.6, 0.46},
       {{"mu_J", 0.093}},
       0.01},
  };
}

TEST(LevenbergMarquardt, FindsTheParametersOfExactPoints) {
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.name);
    auto const points = sampled(
        c.x, c.curve, [](double y) { return 1e-3 * y; }, nullptr);
    auto const found = fit(c.model(points), points, c.fixed);
    for (std::size_t k = 0; k < c.truth.size(); ++k)
      EXPECT_NEAR(found.value[k], c.truth[k], 1e-5 * c.truth[k]) << k;
    EXPECT_LT(found.chi2, 1e-6);
    EXPECT_EQ(found.freedom, c.x.size() - c.truth.size() + c.fixed.size());
  }
}

/// Q* = 1, s = 1 and Q0 = 0 are where logarithms and amplitudes of a start are zero but for
/// rounding.
TEST(LevenbergMarquardt, LeavesStartsAtZero) {
  auto const error = [](double y) { return 0.01 * y; };
  for (double const most : {10.0, 100.0}) {
    auto const points = sampled(
        geometric(1.0 / most, most, 13),
        [](double q) { return 2.0 * std::pow(1.0 + std::pow(q / 1.2, 3.0), 1.5 / 3.0); }, error,
        nullptr);
    auto const model = crossover_model(points);
    std::vector<double> const truth{2.0, 1.2, 3.0, 1.5};
    for (auto const& found :
         {fit(model, points),
          fit_from(model, points, {}, {2.0, std::nextafter(1.0, 0.0), 1.0, 1.5})})
      for (std::size_t k = 0; k < truth.size(); ++k)
        EXPECT_NEAR(found.value[k], truth[k], 1e-5) << most << " " << k;
  }
  auto const points = sampled(
      evenly(0.7, 0.83, 9), [](double phi) { return 1e-6 * std::pow(0.84 - phi, -2.0); }, error,
      nullptr);
  for (double const zero : {0.0, 1e-21})
    for (Fixed const& fixed : {Fixed{}, Fixed{{"phi_J", 0.84}}}) {
      auto const found = fit_from(divergence_model(points), points, fixed, {zero, 2e-6, 0.84, 1.7});
      EXPECT_NEAR(found.value[0], 0.0, 1e-10);
      EXPECT_NEAR(found.value[3], 2.0, 1e-4);
      EXPECT_GT(found.error[0], 0.0);
    }
}

/// Stresses of slow flows are as small as their rate squared: the unit of y changes no fit.
TEST(LevenbergMarquardt, UnitsDoNotMatter) {
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.name);
    std::mt19937_64 random(3);
    auto const points = sampled(
        c.x, c.curve, [&](double y) { return c.noise * y; }, &random);
    auto const model = c.model(points);
    if (model.parameters[0].name == "mu_J") continue;  // of numbers of order 1
    auto const expected = fit(model, points, c.fixed);
    for (double const unit : {1e-14, 1e-20, 1e-30, 1e30}) {
      auto scaled = points;
      for (double& y : scaled.y) y *= unit;
      for (double& error : scaled.error) error *= unit;
      auto const found = fit(c.model(scaled), scaled, c.fixed);
      EXPECT_NEAR(found.chi2, expected.chi2, 1e-6 * expected.chi2) << unit;
      for (std::size_t k = 0; k < found.value.size(); ++k) {
        bool const of_y = model.parameters[k].name == "C" || model.parameters[k].name == "c" ||
                          model.parameters[k].name == "Q0";
        double const by = of_y ? unit : 1.0;
        EXPECT_NEAR(found.value[k] / by, expected.value[k], 1e-5 * std::abs(expected.value[k]))
            << unit << " " << k;
        EXPECT_NEAR(found.error[k] / by, expected.error[k], 1e-4 * expected.error[k])
            << unit << " " << k;
      }
    }
  }
}

/// A law of others, all of it given: how well points agree.
TEST(LevenbergMarquardt, NothingFree) {
  Points const points{{1, 2, 3}, {1.2, 2.0, 2.9}, {0.1, 0.1, 0.1}};
  auto const found = fit(friction_law_model(), points, {{"mu_J", 0.0}, {"c", 1.0}, {"b", 1.0}});
  EXPECT_EQ(found.value, (std::vector<double>{0, 1, 1}));
  EXPECT_EQ(found.error, std::vector<double>(3, 0.0));
  EXPECT_NEAR(found.chi2, 4.0 + 0.0 + 1.0, 1e-12);
  EXPECT_EQ(found.freedom, 3u);
}

/// 1000 noisy sets: pulls of mean 0 and variance 1, chi2 as many as degrees of freedom.
TEST(LevenbergMarquardt, ErrorsAreRight) {
  std::mt19937_64 random(5);
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.name);
    std::vector<Pulls> pulls(c.truth.size());
    double chi2 = 0.0, freedom = 0.0;
    int const sets = 1000;
    for (int set = 0; set < sets; ++set) {
      auto const points = sampled(
          c.x, c.curve, [&](double y) { return c.noise * y; }, &random);
      auto const found = fit(c.model(points), points, c.fixed);
      chi2 += found.chi2 / sets;
      freedom = static_cast<double>(found.freedom);
      for (std::size_t k = 0; k < pulls.size(); ++k)
        if (found.error[k] > 0.0) pulls[k].add(found.value[k], c.truth[k], found.error[k]);
    }
    EXPECT_NEAR(chi2, freedom, 4.0 * std::sqrt(2.0 * freedom / sets) + 0.05);
    for (std::size_t k = 0; k < pulls.size(); ++k) {
      SCOPED_TRACE(k);
      if (c.fixed.contains(c.model(sampled(c.x, c.curve, c.curve, nullptr)).parameters[k].name)) {
        EXPECT_EQ(pulls[k].count, 0);
        continue;
      }
      EXPECT_EQ(pulls[k].count, sets);
      pulls[k].expect_right(0.06);
    }
  }
}

/// With b fixed to 1 the law is a straight line, whose errors are known in closed form.
TEST(LevenbergMarquardt, CovarianceOfALineInClosedForm) {
  Points const points{{1, 2, 3, 5}, {2.1, 2.9, 4.2, 5.8}, {0.1, 0.2, 0.1, 0.3}};
  auto const found = fit(friction_law_model(), points, {{"b", 1.0}});
  double s = 0, sx = 0, sxx = 0, sy = 0, sxy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double const w = 1.0 / (points.error[i] * points.error[i]);
    s += w, sx += w * points.x[i], sxx += w * points.x[i] * points.x[i];
    sy += w * points.y[i], sxy += w * points.x[i] * points.y[i];
  }
  double const det = s * sxx - sx * sx;
  EXPECT_NEAR(found.value[0], (sxx * sy - sx * sxy) / det, 1e-9);
  EXPECT_NEAR(found.value[1], (s * sxy - sx * sy) / det, 1e-9);
  EXPECT_NEAR(found.error[0], std::sqrt(sxx / det), 1e-7);
  EXPECT_NEAR(found.error[1], std::sqrt(s / det), 1e-7);
  EXPECT_NEAR(found.covariance[1], -sx / det, 1e-7);
}

/// Without errors the scatter about the fit tells them: pulls follow Student's t.
TEST(LevenbergMarquardt, ErrorsFromTheScatter) {
  std::mt19937_64 random(6);
  auto const x = geometric(1e-3, 1, 20);
  Pulls pulls;
  for (int set = 0; set < 1000; ++set) {
    auto points = sampled(
        x, [](double i) { return 0.1 + 0.5 * i; }, [](double) { return 0.01; }, &random);
    points.error.clear();
    auto const found = fit(friction_law_model(), points, {{"b", 1.0}});
    pulls.add(found.value[1], 0.5, found.error[1]);
  }
  EXPECT_NEAR(pulls.mean(), 0.0, 0.13);
  EXPECT_NEAR(pulls.variance(), 18.0 / 16.0, 0.2);
}

/// Points below the crossover only say C; what they do not tell has no error, not a small one.
TEST(LevenbergMarquardt, WhatThePointsDoNotTellHasNoError) {
  std::mt19937_64 random(7);
  auto const points = sampled(
      geometric(0.1, 1, 12), [](double) { return 40.0; }, [](double) { return 0.4; }, &random);
  auto const found = fit(crossover_model(points), points, {{"q", 1.3}, {"s", 2.0}});
  EXPECT_TRUE(std::isnan(found.error[1]) || found.error[1] > 0.3 * found.value[1]);
}

TEST(LevenbergMarquardt, BadInputIsNamed) {
  auto const says = [](Points const& points, Fixed const& fixed, std::string const& text) {
    try {
      fit(friction_law_model(), points, fixed);
      ADD_FAILURE() << "accepted; expected: " << text;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  says({{1, 2}, {1, 2}, {}}, {}, "2 points (must be at least 3)");
  says({{1, 1, 1, 1}, {1, 2, 3, 4}, {}}, {}, "all points lie at x = 1");
  says({{1, 2, 3, NAN}, {1, 2, 3, 4}, {}}, {}, "not finite");
  says({{1, 2, 3, 4}, {1, 2, INFINITY, 4}, {}}, {}, "not finite");
  says({{1, 2, 3, 4}, {1, 2, 3, 4}, {1, 1, 0, 1}}, {}, "error is not above 0");
  says({{1, 2, 3, 4}, {1, 2, 3, 4}, {}}, {{"mu_K", 1.0}}, "no parameter");
  says({{1, 2, 3, 4}, {1, 2, 3, 4}, {}}, {{"b", -1.0}}, "must lie above 0");
}

}  // namespace
}  // namespace bagnold::analysis
