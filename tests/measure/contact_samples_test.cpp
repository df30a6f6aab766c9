// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contact_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bagnold::test {

/// Contacts with made-up velocities.
OpenContact contact(std::uint32_t number, ContactVelocities const& velocities) {
  OpenContact made{number, number + 1, 10};
  made.velocities = velocities;
  return made;
}

statistics::Samples named(ContactSamples const& samples, std::string const& name) {
  for (auto const& table : samples.samples())
    if (table.name == name) return table;
  throw std::out_of_range(name);
}

/// An ellipse of points in (V_R, V_N): half-axes 3 and 1, the long one 30 degrees from V_R, about
/// (2, -1).
TEST(ContactSamples, PrincipalAxesOfAMadeUpCloud) {
  ContactSamples samples(SampleChoice(1), true);
  std::uint32_t const n = 360;
  double const c = std::sqrt(3.0) / 2, s = 0.5;
  for (std::uint32_t k = 0; k < n; ++k) {
    double const u = 3 * std::cos(2 * M_PI * k / n), v = std::sin(2 * M_PI * k / n);
    samples.add(contact(k, {0.5, 2 + c * u - s * v, -1 + s * u + c * v}));
  }
  EXPECT_EQ(named(samples, "contact_velocities").rows.size(), n * 4u);
  auto const mean = named(samples, "contact_velocities_mean").rows;
  EXPECT_NEAR(mean[0], 0.5, 1e-12);
  EXPECT_NEAR(mean[1], 2, 1e-12);
  EXPECT_NEAR(mean[2], 2.5, 1e-12);  // V_C_T = V_T + V_R
  EXPECT_NEAR(mean[3], -1, 1e-12);
  double const bessel = static_cast<double>(n) / (n - 1), long2 = 9 / 2.0 * bessel,
               short2 = 0.5 * bessel;
  auto const covariance = named(samples, "contact_velocities_covariance").rows;
  EXPECT_NEAR(covariance[4 * 1 + 1], c * c * long2 + s * s * short2, 1e-12);
  EXPECT_NEAR(covariance[4 * 1 + 3], c * s * (long2 - short2), 1e-12);
  EXPECT_NEAR(covariance[4 * 2 + 3], covariance[4 * 1 + 3], 1e-12);
  auto const axes = named(samples, "contact_velocities_axes");
  ASSERT_EQ(axes.columns.size(), 10u);
  bool seen = false;
  for (std::size_t row = 0; row < axes.rows.size(); row += 10) {
    if (axes.rows[row] != 1 || axes.rows[row + 1] != 3) continue;
    seen = true;
    EXPECT_NEAR(axes.rows[row + 2], 2, 1e-12);
    EXPECT_NEAR(axes.rows[row + 4], long2, 1e-12);
    EXPECT_NEAR(std::abs(axes.rows[row + 5] * c + axes.rows[row + 6] * s), 1, 1e-12);
    EXPECT_NEAR(axes.rows[row + 7], short2, 1e-12);
    EXPECT_NEAR(std::abs(axes.rows[row + 8] * s - axes.rows[row + 9] * c), 1, 1e-12);
  }
  EXPECT_TRUE(seen);
}

TEST(ContactSamples, WithoutRotationHaveTwoColumns) {
  ContactSamples samples(SampleChoice(1), false);
  EXPECT_TRUE(samples.samples().empty());
  samples.add(contact(1, {1, 0, 2}));
  samples.add(contact(2, {3, 0, 4}));
  EXPECT_EQ(named(samples, "contact_velocities").columns.size(), 2u);
  EXPECT_EQ(named(samples, "contact_velocities_mean").rows, (std::vector<double>{2, 3}));
}

/// Which are kept does not depend on the order in which they end, nor on a save in between.
TEST(ContactSamples, OfManyAreAnEvenChoiceInAnyOrder) {
  auto const many = static_cast<std::uint32_t>(3 * ContactSamples::most);
  ContactSamples forth(SampleChoice(5), true), back = forth, half = forth;
  for (std::uint32_t k = 0; k < many; ++k) {
    forth.add(contact(k, {static_cast<Real>(k), 0, 0}));
    back.add(contact(many - 1 - k, {static_cast<Real>(many - 1 - k), 0, 0}));
  }
  auto const kept = named(forth, "contact_velocities").rows;
  EXPECT_EQ(kept.size(), 4 * ContactSamples::most);
  EXPECT_EQ(kept, named(back, "contact_velocities").rows);
  // the mean of numbers 0 .. n - 1 drawn evenly: n / sqrt(12 most) is one standard deviation
  EXPECT_NEAR(named(forth, "contact_velocities_mean").rows[0], (many - 1) / 2.0,
              4 * many / std::sqrt(12.0 * ContactSamples::most));
  for (std::uint32_t k = 0; k < many; k += 2) half.add(contact(k, {static_cast<Real>(k), 0, 0}));
  Numbers saved;
  half.save(saved);
  ContactSamples again(SampleChoice(5), true), other = again;
  again.load(saved);
  for (std::uint32_t k = 1; k < many; k += 2) other.add(contact(k, {static_cast<Real>(k), 0, 0}));
  again.add(other);
  EXPECT_EQ(named(again, "contact_velocities").rows, kept);
}

}  // namespace bagnold::test
