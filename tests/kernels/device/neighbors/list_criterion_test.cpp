// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "src/engine/backends.hpp"
#include "tests/kernels/device/neighbors/listed.hpp"

namespace bagnold::test {

/// Two big disks just out of reach in the direction that shear shortens most, closing in head-on:
/// they touch, unlisted, within a millionth of a diameter of where the list begins to say no. Small
/// disks have the slack that comes from taking d_max for all: (s - 1)(d_max - d_ij)/2s each.
TEST(ListCriterion, IsGivenUpNoSoonerThanItMustBe) {
  using Space = std::tuple_element_t<0, Backends>;
  double const length = 14.0;
  for (double skin : skins) {
    for (double share : {-0.98, -0.4, -1e-3, 1e-9, 1e-3, 0.4, 0.98}) {
      double const strain = share * widest_strain(skin);
      for (double diameter : {1.4, 1.0}) {
        // |S (cos a, sin a)|^2 = 1 + strain^2/2 + strain sin 2a - (strain^2/2) cos 2a is least
        // where (cos 2a, sin 2a) points along (strain^2/2, -strain).
        double const angle = std::atan2(-strain, strain * strain / 2) / 2;
        double const apart = (diameter + skin) * (1 + 1e-7);
        Vec2<Real> const middle{length / 2, length / 2};
        Vec2<Real> const half{apart / 2 * std::cos(angle), apart / 2 * std::sin(angle)};
        Listed<Space> const listed({{middle + half, middle - half}, {diameter, diameter}}, length,
                                   0.3 * length, skin);
        ASSERT_TRUE(listed.rows[0].empty());

        Vec2<Real> const r{2 * half.x + strain * 2 * half.y, 2 * half.y};
        double const distance = std::hypot(r.x, r.y);
        auto const closing = [&](double nonaffine) {
          Vec2<Real> const w = nonaffine / distance * r;
          return listed.moved(strain, {Real(-1) * w, w});
        };
        double const touch = (distance - diameter) / 2;
        ASSERT_EQ(listed.missed(closing(touch + 1e-9), strain), 2u);  // in neither row

        double holds = 0.0, fails = skin;  // the displacement at which the list's word changes
        for (int k = 0; k < 50; ++k) {
          double const between = (holds + fails) / 2;
          (listed.holds(closing(between), strain) ? holds : fails) = between;
        }
        double const s = (diameter + skin) / (distance / (1 + 1e-7));
        double const slack = (s - 1) * (big_diameter - diameter) / (2 * s);
        EXPECT_LT(fails, touch + 1e-9) << skin << " " << share << " " << diameter;
        EXPECT_GT(fails, touch - slack - 1e-6) << skin << " " << share << " " << diameter;
      }
    }
  }
}

TEST(ListCriterion, HoldsNoLongerThanTheShearAloneAllows) {
  for (double skin : skins) {
    double const strain = widest_strain(skin);
    for (double sign : {-1.0, 1.0}) {
      EXPECT_TRUE(list_holds(sign * 0.999 * strain, 0.0, skin));
      EXPECT_FALSE(list_holds(sign * 1.001 * strain, 0.0, skin));
      EXPECT_FALSE(list_holds(sign * 100 * strain, 0.0, skin));
    }
    EXPECT_TRUE(list_holds(0.0, 0.0, skin));
    EXPECT_TRUE(list_holds(0.0, std::pow(0.4999 * skin, 2), skin));
    EXPECT_FALSE(list_holds(0.0, std::pow(0.5001 * skin, 2), skin));
  }
}

/// A state that is no state any more never passes for one whose list holds.
TEST(ListCriterion, DoesNotHoldForWhatIsNoNumber) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  double const infinity = std::numeric_limits<double>::infinity();
  for (double bad : {nan, infinity, std::numeric_limits<double>::max()}) {
    EXPECT_FALSE(list_holds(0.0, bad, 0.3));
    EXPECT_FALSE(list_holds(bad, 0.0, 0.3));
  }
}

/// w is what a disk does beyond the mean flow at its height at the build.
TEST(ListCriterion, NonaffineDisplacementsAreBeyondTheMeanFlow) {
  Vec2<Real> const at_build{3.0, 2.0};
  // r = r_0 + 0.1 * 2 x^ + (0.03, 0.04): |w| = 0.05.
  EXPECT_NEAR(nonaffine2({3.0 + 0.2 + 0.03, 2.04}, at_build, 0.1), 0.0025, 1e-15);
  EXPECT_NEAR(nonaffine2({3.0 - 0.2 + 0.03, 2.04}, at_build, -0.1), 0.0025, 1e-15);
  EXPECT_NEAR(nonaffine2({3.2, 2.0}, at_build, 0.1), 0.0, 1e-30);
}

}  // namespace bagnold::test
