// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/curves.hpp"

#include <gtest/gtest.h>

#include "src/config/errors.hpp"
#include "tests/analysis/tables.hpp"

namespace bagnold::analysis {
namespace {

constexpr auto phi_key = "disks.packing_fraction";

/// One curve a rate; the strain, which follows from the rate, tells the curves apart as well.
TEST(Curves, SeedsAreOneDatumAndOtherKeysTellCurvesApart) {
  auto const table = small_table();
  auto const curves = curves_of(table, {phi_key, {}, {}, {}});
  ASSERT_EQ(curves.size(), 2u);
  for (auto const& curve : curves) {
    ASSERT_EQ(curve.data.size(), 2u);
    EXPECT_EQ(curve.data[0].rows.size(), 3u);
    // in rising order of phi, though the table falls
    EXPECT_EQ(table.keys.at(phi_key).numbers[curve.data[0].rows[0]], 0.6);
  }
  ASSERT_EQ(curves[0].labels.size(), 2u);
  EXPECT_EQ(curves[0].labels[1], Label("shear.strain_rate", "0.0001"));
}

TEST(Curves, AKeyThatFollowsIsNoLabel) {
  auto const along_rate = curves_of(small_table(), {"shear.strain_rate", {}, {}, {}});
  ASSERT_EQ(along_rate.size(), 2u);
  EXPECT_EQ(along_rate[0].labels, std::vector<Label>({{phi_key, "0.7"}}));
  auto const apart = curves_of(
      small_table(), {phi_key, {}, {"shear.strain_rate"}, {{"shear.strain_rate", "1e-5"}}});
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_TRUE(apart[0].labels.empty());
}

/// Each packing fraction at elasticities of its own is a curve; one elasticity each is one curve.
TEST(Curves, APhysicalNumberFollowsOnlyOneToOne) {
  SweepTable table;
  table.points = 4;
  auto& phi = table.keys[phi_key].numbers = {0.7, 0.7, 0.8, 0.8};
  table.keys["disks.elasticity"].numbers = {1, 2, 3, 4};
  table.observables["p"] = {{1, 2, 3, 4}, {1, 1, 1, 1}};
  auto const curves = curves_of(table, {"disks.elasticity", {}, {}, {}});
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[1].labels, std::vector<Label>({{phi_key, "0.8"}}));
  phi = {0.6, 0.7, 0.8, 0.81};
  EXPECT_EQ(curves_of(table, {"disks.elasticity", {}, {}, {}}).size(), 1u);
}

TEST(Curves, FailedSeedsAreLeftOut) {
  auto table = small_table();
  table.observables["p"].mean[1] = nothing;
  EXPECT_EQ(count_failed(table), 1u);
  auto const curves = curves_of(table, {phi_key, {}, {}, {{"shear.strain_rate", "0.0001"}}});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].data[1].rows, (std::vector<std::size_t>{0, 2}));
}

TEST(Curves, BadChoices) {
  auto const table = small_table();
  EXPECT_THROW(curves_of(table, {"disks.elasticity", {}, {}, {}}), InputError);
  EXPECT_THROW(curves_of(table, {phi_key, {"disks.mass"}, {}, {}}), InputError);
  EXPECT_THROW(curves_of(table, {phi_key, {}, {}, {{"disks.mass", "equal"}}}), InputError);
  EXPECT_THROW(curves_of(table, {phi_key, {}, {}, {{phi_key, "0.5"}}}), InputError);
  // both rates on one curve: two data at each phi
  EXPECT_THROW(curves_of(table, {phi_key, {"disks.seed"}, {}, {}}), InputError);
}

}  // namespace
}  // namespace bagnold::analysis
