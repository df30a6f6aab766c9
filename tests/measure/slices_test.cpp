// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/slices.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "src/measure/disk_stress.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold {
namespace {

using C = SliceColumns;

class SliceSums : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Laws, SliceSums, testing::ValuesIn(test::law_names()));

/// What the engine sums over the same configuration is the oracle.
TEST_P(SliceSums, AddUpToThoseOfTheBox) {
  for (double const aspect : {1.0, 4.0, 0.25}) {
    Scene scene = test::small_scene(GetParam());
    scene.disks.box_aspect = aspect;
    State const begin = test::shaken_start(scene);
    auto const simulation = test::simulate(scene, begin, "serial");
    test::advance(*simulation, 150);
    State const state = simulation->state();
    auto const sums = test::advance(*simulation, 1, 1).sums;

    std::vector<double> mass;
    for (double const d : state.diameter) mass.push_back(disk_mass(scene.mass_by_area(), d));
    Slices const slices(state.box_length, state.box_height());
    constexpr std::pair<int, int> same[] = {{C::kinetic_xx, SumColumns::kinetic_xx},
                                            {C::kinetic_xy, SumColumns::kinetic_xy},
                                            {C::kinetic_yy, SumColumns::kinetic_yy},
                                            {C::elastic_xx, SumColumns::elastic_xx},
                                            {C::elastic_xy, SumColumns::elastic_xy},
                                            {C::elastic_yy, SumColumns::elastic_yy},
                                            {C::dissipative_xx, SumColumns::dissipative_xx},
                                            {C::dissipative_xy, SumColumns::dissipative_xy},
                                            {C::dissipative_yx, SumColumns::dissipative_yx},
                                            {C::dissipative_yy, SumColumns::dissipative_yy},
                                            {C::contacts, SumColumns::contacts}};
    for (double const origin : {0.0, 3.21, -5.4}) {
      auto const of_slices = slice_sums(slices, state, mass, disk_stress(scene, state), origin);
      std::vector<double> total(C::count);
      for (std::size_t k = 0; k < of_slices.size(); ++k) total[k % C::count] += of_slices[k];
      for (auto const& [here, there] : same) {
        double const expected = sums[static_cast<std::size_t>(there)];
        EXPECT_NE(expected, 0.0) << there;
        EXPECT_NEAR(total[static_cast<std::size_t>(here)], expected,
                    1e-10 * std::abs(expected) + 1e-14)
            << "column " << there << ", origin " << origin << ", aspect " << aspect;
      }
      EXPECT_NEAR(total[C::area] / (state.box_length * state.box_height()),
                  scene.disks.packing_fraction, 1e-12);
      EXPECT_EQ(total[C::disks], 64.0);
    }
  }
}

/// A disk given by its image above is in the slice of the one in the box.
TEST(SliceArea, ImagesAreAHeightApart) {
  Slices const slices(30.0, 12.0);
  State state;
  state.box_length = 30.0;
  state.box_aspect = 0.4;
  state.strain_rate = 1e-3;
  state.position = {{1.0, 12.0 + 6.75}};
  state.velocity = {{0.0, 0.0}};
  state.diameter = {1.0};
  auto const sums = slice_sums(slices, state, {1.0}, std::vector<Sums<false>>(1), 0.0);
  EXPECT_EQ(sums[4 * C::count + C::disks], 1.0);
}

TEST(SliceArea, CutsADiskAtTheEdges) {
  Slices const slices(30.0, 12.0);  // 8 slices, 1.5 thick
  ASSERT_EQ(slices.n, 8u);
  State state;
  state.box_length = 30.0;
  state.box_aspect = 0.4;
  state.strain_rate = 1e-3;
  state.position = {{1.0, 1.5}, {5.0, 0.0}};  // across an inner edge; across the edge of the box
  state.velocity = {{0.0, 0.0}, {0.0, 0.0}};
  state.diameter = {1.0, 1.4};
  auto const sums = slice_sums(slices, state, {1.0, 1.0}, std::vector<Sums<false>>(2), 0.0);
  double const small = std::numbers::pi / 8, big = std::numbers::pi * 0.49 / 2;  // halves
  EXPECT_NEAR(sums[0 * C::count + C::area], small + big, 1e-14);
  EXPECT_NEAR(sums[1 * C::count + C::area], small, 1e-14);
  EXPECT_NEAR(sums[7 * C::count + C::area], big, 1e-14);
  EXPECT_EQ(sums[1 * C::count + C::disks], 1.0);
}

}  // namespace
}  // namespace bagnold
