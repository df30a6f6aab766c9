// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contact_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace bagnold::test {

using Velocities = std::vector<ContactVelocities>;

std::vector<double> rows(std::vector<statistics::Samples> const& tables, std::string const& name) {
  for (auto const& table : tables)
    if (table.name == name) return table.rows;
  throw std::out_of_range(name);
}

/// An ellipse of points in (V_R, V_N): half-axes 3 and 1, the long one 30 degrees from V_R, about
/// (2, -1).
TEST(VelocityTables, PrincipalAxesOfAMadeUpCloud) {
  Velocities made;
  std::uint32_t const n = 360;
  double const c = std::sqrt(3.0) / 2, s = 0.5;
  for (std::uint32_t k = 0; k < n; ++k) {
    double const u = 3 * std::cos(2 * M_PI * k / n), v = std::sin(2 * M_PI * k / n);
    made.push_back({0.5, 2 + c * u - s * v, -1 + s * u + c * v});
  }
  auto const tables = VelocityTables{"some", "", true}(made, sums_of(made));
  EXPECT_EQ(rows(tables, "some").size(), n * 4u);
  auto const mean = rows(tables, "some_mean");
  EXPECT_NEAR(mean[0], 0.5, 1e-12);
  EXPECT_NEAR(mean[1], 2, 1e-12);
  EXPECT_NEAR(mean[2], 2.5, 1e-12);  // V_C_T = V_T + V_R
  EXPECT_NEAR(mean[3], -1, 1e-12);
  double const long2 = 9 / 2.0, short2 = 0.5;
  auto const covariance = rows(tables, "some_covariance");
  EXPECT_NEAR(covariance[4 * 1 + 1], c * c * long2 + s * s * short2, 1e-12);
  EXPECT_NEAR(covariance[4 * 1 + 3], c * s * (long2 - short2), 1e-12);
  EXPECT_NEAR(covariance[4 * 2 + 3], covariance[4 * 1 + 3], 1e-12);
  auto const axes = rows(tables, "some_axes");
  bool seen = false;
  for (std::size_t row = 0; row < axes.size(); row += 10) {
    if (axes[row] != 1 || axes[row + 1] != 3) continue;
    seen = true;
    EXPECT_NEAR(axes[row + 2], 2, 1e-12);
    EXPECT_NEAR(axes[row + 4], long2, 1e-12);
    EXPECT_NEAR(std::abs(axes[row + 5] * c + axes[row + 6] * s), 1, 1e-12);
    EXPECT_NEAR(axes[row + 7], short2, 1e-12);
    EXPECT_NEAR(std::abs(axes[row + 8] * s - axes[row + 9] * c), 1, 1e-12);
  }
  EXPECT_TRUE(seen);
}

/// Sums say what there is in all, of which rows are but some: two of three here.
TEST(VelocityTables, MeansAndCovarianceAreThoseOfTheSums) {
  Velocities const all{{1, 10, 2}, {3, 20, 6}, {8, 60, 1}}, some{all[0], all[1]};
  auto const tables = VelocityTables{"some", "", true}(some, sums_of(all));
  EXPECT_EQ(rows(tables, "some").size(), 8u);
  EXPECT_NEAR(rows(tables, "some_mean")[2], 34, 1e-12);
  EXPECT_NEAR(rows(tables, "some_covariance")[4 * 0 + 3], (2 + 18 + 8) / 3.0 - 4 * 3, 1e-12);
}

TEST(VelocityTables, WithoutRotationHaveTwoColumns) {
  VelocityTables const tables{"some", "", false};
  EXPECT_TRUE(tables({{1, 0, 2}}, sums_of({{1, 0, 2}})).empty());
  Velocities const two{{1, 0, 2}, {3, 0, 4}};
  EXPECT_EQ(rows(tables(two, sums_of(two)), "some"), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(rows(tables(two, sums_of(two)), "some_mean"), (std::vector<double>{2, 3}));
}

/// Which are kept does not depend on the order in which they come, nor on a save in between, and
/// nothing from the limit on would be.
TEST(ContactSamples, OfManyAreAnEvenChoiceInAnyOrder) {
  auto const many = static_cast<std::uint32_t>(3 * ContactSamples::most);
  SampleChoice const choice(5);
  auto const made = [&](std::uint32_t k) {
    return ContactPick{choice.rank_at(k, k + 1, 10), {static_cast<Real>(k), 0, 0}};
  };
  auto const first = [](ContactSamples const& samples) {
    std::vector<Real> all;
    for (auto const& v : samples.velocities()) all.push_back(v.tangential);
    return all;
  };
  ContactSamples forth, back, half, limited;
  EXPECT_GT(forth.limit(), 1);
  for (std::uint32_t k = 0; k < many; ++k) {
    forth.add(made(k));
    back.add(made(many - 1 - k));
    if (made(k).rank < limited.limit()) limited.add(made(k));
  }
  auto const kept = first(forth);
  EXPECT_EQ(kept.size(), ContactSamples::most);
  EXPECT_EQ(kept, first(back));
  EXPECT_EQ(kept, first(limited));
  EXPECT_NEAR(forth.limit(), 1 / 3.0, 0.02);
  // the mean of numbers 0 .. n - 1 drawn evenly: n / sqrt(12 most) is one standard deviation
  double const mean = std::accumulate(kept.begin(), kept.end(), 0.0) / ContactSamples::most;
  EXPECT_NEAR(mean, (many - 1) / 2.0, 4 * many / std::sqrt(12.0 * ContactSamples::most));
  for (std::uint32_t k = 0; k < many; k += 2) half.add(made(k));
  ContactSamples again, other;
  again.restore(half.numbers());
  for (std::uint32_t k = 1; k < many; k += 2) other.add(made(k));
  again.add(other);
  EXPECT_EQ(first(again), kept);
}

}  // namespace bagnold::test
