// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/branches.hpp"

#include "src/config/errors.hpp"
#include "tests/analysis/fit/noise.hpp"

namespace bagnold::analysis {
namespace {

/// ln P about a coexistence region: the branch below it rises ever more steeply.
double curved(double x) {
  return 40.0 * x + 700.0 * std::pow(std::min(0.0, x - 0.7881), 2) +
         150.0 * std::max(0.0, x - 0.7881) - 120.0 * std::max(0.0, x - 0.8013) +
         250.0 * std::pow(std::max(0.0, x - 0.8013), 2);
}

double smooth(double x) { return 60.0 * x - 300.0 * std::pow(x - 0.79, 2); }

auto const error = [](double) { return 0.02; };

TEST(Branches, FindKinksOfExactPoints) {
  auto const points = sampled(evenly(0.75, 0.83, 25), curved, error, nullptr);
  for (std::size_t const left : {2, 3}) {
    auto const found = fit_branches(points, 2, left, 2);
    EXPECT_NEAR(found.place(0), 0.7881, 1e-5);
    EXPECT_NEAR(found.place(1), 0.8013, 1e-5);
    EXPECT_NEAR(found.bend(0), 150.0, 0.1);
    EXPECT_NEAR(found.bend(1), -120.0, 0.1);
    for (double const x : {0.76, 0.79, 0.82}) EXPECT_NEAR(found(x), curved(x), 1e-4);
  }
  auto const one = [](double x) {
    return 2.0 * std::max(0.0, x - 4.3) + 0.3 * std::pow(std::min(0.0, x - 4.3), 2);
  };
  EXPECT_NEAR(fit_branches(sampled(evenly(0, 9, 14), one, error, nullptr), 1, 2, 2).place(0), 4.3,
              1e-4);
}

TEST(Branches, ErrorsAreRight) {
  std::mt19937_64 random(31);
  Pulls first, second;
  for (int set = 0; set < 300; ++set) {
    auto const found =
        fit_branches(sampled(evenly(0.75, 0.83, 33), curved, error, &random), 2, 2, 2);
    first.add(found.place(0), 0.7881, found.place_error(0));
    second.add(found.place(1), 0.8013, found.place_error(1));
  }
  for (auto const* pulls : {&first, &second}) pulls->expect_right(0.1);
}

TEST(Branches, APolynomialDescribesWhatIsSmooth) {
  auto const place = evenly(0.75, 0.83, 20);
  EXPECT_LT(fit_polynomial(sampled(place, smooth, error, nullptr), 8).chi2, 1e-6);
  EXPECT_GT(fit_polynomial(sampled(place, curved, error, nullptr), 8).chi2, 100.0);
}

TEST(Branches, BadInput) {
  EXPECT_THROW(fit_branches({{1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}, {}}, 2, 2, 2), InputError);
  EXPECT_THROW(fit_branches({{1, 2, 2, 3, 4, 5, 6, 7}, {1, 2, 3, 4, 5, 6, 7, 8}, {}}, 1, 2, 2),
               InputError);
  EXPECT_THROW(fit_branches({{1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6}, {}}, 3, 2, 2), InputError);
}

}  // namespace
}  // namespace bagnold::analysis
