// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/cpu/contacts/contact_sample.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace bagnold::test {

/// A big disk at the origin, a small one straight above it, touching: r_ij = (0, -1.2).
struct Stack {
  Vec2<Real> separation{0, -1.2};
  Real big = 1.4, small = 1.0, rate = 0.5;

  ContactVelocities velocities(Vec2<Real> velocity, Real spin_big, Real spin_small) const {
    Real const spin = (big * spin_big + small * spin_small) / (big + small);
    return contact_velocities(separation, velocity, spin, rate);
  }
};

/// t = z x y^ = -x^: what moves to the left past the disk above has a positive V_T.
TEST(ContactVelocities, OfTranslation) {
  Stack const stack;
  auto const left = stack.velocities({-0.3, 0}, 0, 0), up = stack.velocities({0, 0.3}, 0, 0);
  EXPECT_NEAR(left.tangential, 0.6, 1e-15);
  EXPECT_NEAR(left.normal, 0, 1e-15);
  EXPECT_NEAR(left.at_contact(), 0.6, 1e-15);
  EXPECT_NEAR(up.normal, 0.6, 1e-15);
  EXPECT_NEAR(up.tangential, 0, 1e-15);
}

/// The contact is 1.2 (1.4 / 2.4) = 0.7 from the big centre and 0.5 from the small one (P2 Eq. 6),
/// so surfaces there move by -0.7 and +0.5 times the spins along x, against t = -x^.
TEST(ContactVelocities, OfRotationHaveTheirArmsFromTheCentresToTheContact) {
  Stack const stack;
  EXPECT_NEAR(stack.velocities({0, 0}, 0.2, 0).rotational, 0.7 * 0.2 / 0.5, 1e-15);
  EXPECT_NEAR(stack.velocities({0, 0}, 0, 0.2).rotational, 0.5 * 0.2 / 0.5, 1e-15);
  auto const gears = stack.velocities({0, 0}, 0.5, -0.7);
  EXPECT_NEAR(gears.rotational, 0, 1e-15);
  auto const rolls = stack.velocities({0.5 * 0.3, 0}, 0, 0.3);  // over the one at rest
  EXPECT_NEAR(rolls.at_contact(), 0, 1e-15);
  EXPECT_NEAR(rolls.tangential, -0.3, 1e-15);
}

TEST(ContactVelocities, AreTheSameSeenFromEitherDisk) {
  auto const one = contact_velocities({0.3, -0.9}, {0.1, 0.2}, 0.7, 0.01);
  auto const other = contact_velocities({-0.3, 0.9}, {-0.1, -0.2}, 0.7, 0.01);
  EXPECT_DOUBLE_EQ(one.tangential, other.tangential);
  EXPECT_DOUBLE_EQ(one.rotational, other.rotational);
  EXPECT_DOUBLE_EQ(one.normal, other.normal);
}

/// The last look before the end is at each of the steps with equal chance, for any length.
TEST(SampleChoice, IsEvenOverTheSteps) {
  SampleChoice const choice(7);
  std::uint32_t const contacts = 60000;
  for (std::int64_t const length : {1, 2, 3, 10, 1000}) {
    std::int64_t const bins = std::min<std::int64_t>(length, 10), begin = 123456789;
    std::vector<double> count(static_cast<std::size_t>(bins));
    std::size_t looks = 0;
    for (std::uint32_t k = 0; k < contacts; ++k) {
      std::int64_t last = 0;
      for (auto due = choice.first(begin); due < begin + length; ++looks) {
        ASSERT_GE(due, begin);
        last = due;
        due = choice.next(k, k + 1 + k % 7, begin, due);
        ASSERT_GT(due, last);
      }
      ++count[static_cast<std::size_t>((last - begin) * bins / length)];
    }
    double const expected = static_cast<double>(contacts) / static_cast<double>(bins);
    double chi2 = 0;
    for (double const n : count) chi2 += (n - expected) * (n - expected) / expected;
    EXPECT_LT(chi2, 33.7) << length;  // 9 degrees of freedom: once in ten thousand
    double harmonic = 0;
    for (std::int64_t n = 1; n <= length; ++n) harmonic += 1.0 / static_cast<double>(n);
    EXPECT_NEAR(static_cast<double>(looks) / contacts, harmonic, 0.05) << length;
  }
}

/// Sums of made-up pairs, in their own units: V_T = 0.3, V_R = 1.2 * 0.5, V_N = -0.1 for the one,
/// of weight 1/2 for the other.
TEST(ContactMotion, SumsProductsOfVelocities) {
  using M = ContactMotion;
  ContactMotion one, both;
  one.add(1, {0, -1.2}, {-0.3, -0.1}, 0.5);
  EXPECT_NEAR(one.value[M::tangential], 0.3, 1e-15);
  EXPECT_NEAR(one.value[M::rotational], 0.6, 1e-15);
  EXPECT_NEAR(one.value[M::normal], -0.1, 1e-15);
  EXPECT_NEAR(one.value[M::tangential2], 0.09, 1e-15);
  EXPECT_NEAR(one.value[M::rotational2], 0.36, 1e-15);
  EXPECT_NEAR(one.value[M::normal2], 0.01, 1e-15);
  EXPECT_NEAR(one.value[M::tangential_rotational], 0.18, 1e-15);
  EXPECT_NEAR(one.value[M::tangential_normal], -0.03, 1e-15);
  EXPECT_NEAR(one.value[M::rotational_normal], -0.06, 1e-15);
  both.add(0.5, {0, -1.2}, {-0.3, -0.1}, 0.5);
  both += one;
  for (int c = 0; c < M::count; ++c) EXPECT_NEAR(both.value[c], 1.5 * one.value[c], 1e-15) << c;
}

/// Of contacts of all lengths each configuration has the same chance, whatever its contact's.
TEST(ContactPicker, IsEvenOverContactsInTime) {
  ContactPicker const picker{SampleChoice(3), 100, 0.25};
  std::vector<ContactPick> picks;
  std::size_t asked = 0;
  auto const pick = [&](std::uint32_t a, std::uint32_t b, std::int64_t step) {
    picker(picks, step, a, b, [&] { return ++asked, ContactVelocities{}; });
  };
  for (std::int64_t step = 0; step < 100; ++step) pick(1, 2, step);
  EXPECT_TRUE(picks.empty());
  for (std::int64_t step = 100; step < 40100; ++step) pick(1, 2, step);
  EXPECT_NEAR(static_cast<double>(picks.size()), 1e4, 4 * std::sqrt(40000 * 3 / 16.0));
  for (std::uint32_t a = 0; a < 40000; ++a) pick(a, a + 1, 500);
  EXPECT_NEAR(static_cast<double>(picks.size()), 2e4, 4 * std::sqrt(80000 * 3 / 16.0));
  EXPECT_EQ(asked, picks.size());
  for (auto const& one : picks) EXPECT_LT(one.rank, 0.25);
}

TEST(SampleChoice, DependsOnSeedAndDisksNotOnTheirOrder) {
  SampleChoice const one(1), two(2), off;
  EXPECT_EQ(one.next(3, 8, 10, 500), one.next(8, 3, 10, 500));
  EXPECT_NE(one.next(3, 8, 10, 500), one.next(3, 9, 10, 500));
  EXPECT_NE(one.next(3, 8, 10, 500), two.next(3, 8, 10, 500));
  EXPECT_NE(one.rank(3, 8, 10), one.rank(3, 8, 11));
  EXPECT_NE(one.rank(3, 8, 10), one.rank_at(3, 8, 10));
  EXPECT_EQ(one.rank_at(3, 8, 10), one.rank_at(8, 3, 10));
  EXPECT_EQ(off.first(10), SampleChoice::never);
}

}  // namespace bagnold::test
