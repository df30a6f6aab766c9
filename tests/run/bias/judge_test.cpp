// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "src/statistics/student.hpp"

namespace bagnold::bias {
namespace {

constexpr double strain = 0.03;

/// Pairs by a formula that NumPy has too.
std::vector<Pair> made(int count, bool gas) {
  std::vector<Pair> pairs;
  for (int k = 0; k < count; ++k) {
    double const s = std::sin(1.7 * k + 0.3), c = std::cos(2.3 * k);
    Averages const f{.p = 2e-4 * (1 + 0.05 * s),
                     .sigma = 6e-5 * (1 + 0.08 * c),
                     .contact_number = 3.1 + 0.1 * s * c,
                     .temperature = 5e-9 * (1 + 0.2 * c),
                     .kinetic_pressure = (gas ? 4e-6 : 2e-8) * (1 + 0.2 * c),
                     .temperature_before = 5e-9 * (1 + 0.2 * c) + 1e-11 * s};
    pairs.push_back({k,
                     {.p = f.p * (1.004 + 0.003 * c),
                      .sigma = f.sigma * (0.997 + 0.004 * s),
                      .contact_number = f.contact_number * (1.001 + 0.0005 * c * s),
                      .temperature = f.temperature * (1.002 + 0.001 * s),
                      .kinetic_pressure = f.kinetic_pressure * 1.001,
                      .temperature_before = f.temperature_before * (1.0005 + 0.0002 * c)},
                     f});
  }
  return pairs;
}

struct Expected {
  double judged, bound, stated, error;
};

void expect(Judgement const& found, std::array<Expected, quantities> const& expected) {
  for (std::size_t q = 0; q < quantities; ++q) {
    SCOPED_TRACE(quantity_names[q]);
    EXPECT_NEAR(found.judged[q].value, expected[q].judged, 1e-12);
    EXPECT_NEAR(found.judged[q].bound, expected[q].bound, 1e-11);
    EXPECT_NEAR(found.stated[q].value, expected[q].stated, 1e-12);
    EXPECT_NEAR(found.stated[q].error, expected[q].error, 1e-11);
  }
}

/// Numbers by NumPy and SciPy, written from shared formulas of the rule, not from this code.
TEST(BiasJudge, AgreesWithNumpy) {
  auto const six = judge(made(6, false), 0.01, strain, 0);
  EXPECT_FALSE(six.gas);
  expect(six, {{{0.00423773951267, 0.00261474606013, 0.00423773951267, 0.00251082191866},
                {-0.00226444107242, 0.00296277113906, -0.00226444107242, 0.00190045863587},
                {0.000894025410619, 0.000572704511626, 0.000894025410619, 0.000535606267202},
                {0.0021562022095, 0.000892484936786, 0.0021562022095, 0.00117205509354},
                {-0.00647474231375, 0.00475004071758, -0.00647474231375, 0.00405821504844}}});
  auto const gas = judge(made(9, true), 0.01, strain, 0);
  EXPECT_TRUE(gas.gas);
  expect(gas, {{{0.00427633894985, 0.00189789121883, 0.0182975283937, 0.0095853148524},
                {-0.00259476764597, 0.00234483108223, 0.00441582707593, 0.00285130200588},
                {0.000982403450261, 0.0005069099745, 0.00799299817217, 0.00422459152507},
                {0.0140211894438, 0.00524047298321, 0.0140211894438, 0.00750856280461},
                {-0.00684184853245, 0.00309297369031, -0.0138524432544, 0.00723177968951}}});
}

/// Pairs of a bias each, alike but for a scatter of `scatter`.
std::vector<Pair> biased(double p, double sigma, double z, double t, double scatter = 1e-4) {
  std::vector<Pair> pairs;
  for (int k = 0; k < 4; ++k) {
    double const s = k % 2 == 0 ? scatter : -scatter;
    pairs.push_back(
        {k, {1 + p + s, 1 + sigma + s, 1 + z + s, 1 + t + s, 1e-4, 1}, {1, 1, 1, 1, 1e-4, 1}});
  }
  return pairs;
}

Verdict verdict(std::vector<Pair> const& pairs, double loss = 0) {
  return judge(pairs, 0.01, strain, loss).verdict;
}

/// Bounds of each quantity, by hand: e = 3.182 (1e-4^2 4/12 + 2e-4^2)^(1/2) = 6.6e-4.
TEST(BiasJudge, RefusesAndAccepts) {
  EXPECT_EQ(verdict(biased(0, 0, 0, 0)), Verdict::accepted);
  for (double const sign : {1.0, -1.0}) {
    auto const each = [&](double b) {
      return std::array{verdict(biased(sign * b, 0, 0, 0)), verdict(biased(0, sign * b, 0, 0)),
                        verdict(biased(0, 0, sign * b, 0))};
    };
    for (auto const v : each(0.0108)) EXPECT_EQ(v, Verdict::refused);
    for (auto const v : each(0.0105)) EXPECT_EQ(v, Verdict::none);
    for (auto const v : each(0.0063)) EXPECT_EQ(v, Verdict::none);
    for (auto const v : each(0.0061)) EXPECT_EQ(v, Verdict::accepted);
    EXPECT_EQ(verdict(biased(0, 0, 0, sign * 0.0308)), Verdict::refused);
    EXPECT_EQ(verdict(biased(0, 0, 0, sign * 0.0305)), Verdict::none);
    EXPECT_EQ(verdict(biased(0, 0, 0, sign * 0.0295)), Verdict::accepted);
  }
  EXPECT_EQ(verdict(biased(0.012, 0, 0, 0, 0.01)), Verdict::none);  // scatter hides it
}

/// More of a bias is still to come after a short stretch: 2 |b| + e counts after a quarter.
TEST(BiasJudge, CountsMoreOfABiasOfShortStretches) {
  auto const quarter = [](double b) { return judge(biased(b, 0, 0, 0), 0.01, strain / 4, 0); };
  EXPECT_EQ(quarter(0.0046).verdict, Verdict::accepted);
  EXPECT_EQ(quarter(0.0048).verdict, Verdict::none);
  auto const p = quarter(0.0046).stated[pressure];
  EXPECT_NEAR(p.error, std::hypot(0.0046, quarter(0).stated[pressure].error), 1e-6);
}

/// In a gas T_g has the tolerance itself, and the loss of a collision counts before all.
TEST(BiasJudge, JudgesAGasByTheSlopeOfItsTemperature) {
  auto const gas = [](double rise) {
    auto pairs = biased(0.008, 0, 0, 0);
    for (auto& [step, c, f] : pairs) {
      c.kinetic_pressure = f.kinetic_pressure = 0.15;  // relaxes over 0.3: 20 times the distance
      c.temperature = 1 + rise;
    }
    return pairs;
  };
  EXPECT_EQ(verdict(gas(4e-4)), Verdict::accepted);   // 0.8%, e = 0.06%
  EXPECT_EQ(verdict(gas(4.8e-4)), Verdict::none);     // 0.96%
  EXPECT_EQ(verdict(gas(5.5e-4)), Verdict::refused);  // 1.1%
  EXPECT_EQ(verdict(gas(-5.5e-4)), Verdict::refused);
  EXPECT_EQ(verdict(gas(0), 0.0099), Verdict::accepted);  // p of 0.8% is only not refused
  EXPECT_EQ(verdict(gas(0), -0.0101), Verdict::refused);
  EXPECT_EQ(verdict(biased(0, 0, 0, 0), 0.5), Verdict::accepted);  // of no gas it is not asked
}

TEST(BiasJudge, SaysNothingWhereNothingIsKnown) {
  auto none = biased(0, 0, 0, 0);
  for (auto& [step, c, f] : none) c.contact_number = f.contact_number = 0;
  EXPECT_EQ(verdict(none), Verdict::none);
}

/// Tables of Student's t.
TEST(BiasJudge, Quantiles) {
  EXPECT_NEAR(statistics::student_quantile(1), 12.706, 5e-4);
  EXPECT_NEAR(statistics::student_quantile(3), 3.182, 5e-4);
  EXPECT_NEAR(statistics::student_quantile(19), 2.093, 5e-4);
  EXPECT_NEAR(statistics::student_quantile(100), 1.984, 5e-4);
}

}  // namespace
}  // namespace bagnold::bias
