// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "src/config/scene_file.hpp"
#include "tests/sweep/scenes.hpp"

namespace bagnold::sweep {
namespace {

using Pair = std::pair<double, std::int64_t>;

std::vector<Pair> elasticity_and_seed(Sweep const& sweep) {
  std::vector<Pair> list;
  for (auto const& point : sweep.points)
    list.emplace_back(point.scene.disks.elasticity, point.scene.disks.seed);
  return list;
}

TEST(SweepExpansion, GridHasTheLastKeyFastest) {
  auto const sweep = expand(R"([sweep]
grid = { "disks.elasticity" = [1, 10, 5], "disks.seed" = [7, 2] })");
  EXPECT_EQ(sweep.keys, (std::vector<std::string>{"disks.elasticity", "disks.seed"}));
  EXPECT_EQ(elasticity_and_seed(sweep),
            (std::vector<Pair>{{1, 7}, {1, 2}, {10, 7}, {10, 2}, {5, 7}, {5, 2}}));
}

TEST(SweepExpansion, KeysKeepTheOrderOfTheFile) {
  // alphabetical order would be the other
  auto const sweep = expand(R"([sweep]
grid = { "disks.seed" = [7, 2], "disks.elasticity" = [1, 10] })");
  EXPECT_EQ(elasticity_and_seed(sweep), (std::vector<Pair>{{1, 7}, {10, 7}, {1, 2}, {10, 2}}));
}

TEST(SweepExpansion, KeysMayBeWrittenAsTables) {
  auto const sweep = expand(R"([sweep.grid]
disks.seed = [7, 2]
disks.elasticity = [1, 10]
)");
  EXPECT_EQ(elasticity_and_seed(sweep), (std::vector<Pair>{{1, 7}, {10, 7}, {1, 2}, {10, 2}}));
}

TEST(SweepExpansion, ZipWalksTogether) {
  auto const sweep = expand(R"([sweep]
zip = { "disks.elasticity" = [1, 10, 1], "disks.seed" = [3, 1, 2] })");
  EXPECT_EQ(elasticity_and_seed(sweep), (std::vector<Pair>{{1, 3}, {10, 1}, {1, 2}}));
}

TEST(SweepExpansion, EveryRowOfZipHasTheWholeGrid) {
  auto const sweep = expand(R"([sweep]
grid = { "disks.seed" = [1, 2] }
zip = { "disks.elasticity" = [1, 10], "shear.strain" = [3, 4] })");
  using Three = std::tuple<double, double, std::int64_t>;
  std::vector<Three> list;
  for (auto const& point : sweep.points)
    list.emplace_back(point.scene.disks.elasticity, point.scene.shear.strain,
                      point.scene.disks.seed);
  EXPECT_EQ(list, (std::vector<Three>{{1, 3, 1}, {1, 3, 2}, {10, 4, 1}, {10, 4, 2}}));
  EXPECT_EQ(sweep.keys,
            (std::vector<std::string>{"disks.elasticity", "shear.strain", "disks.seed"}));
}

TEST(SweepExpansion, ValuesArriveBitForBit) {
  auto const sweep = expand(R"([sweep]
grid = { "shear.strain_rate" = [1e-4, 0.1, 1.2345678901234567e-3, 3_0.0e-5] })");
  std::vector<double> rates;
  for (auto const& point : sweep.points) {
    rates.push_back(point.scene.shear.strain_rate);
    EXPECT_EQ(std::get<double>(point.values[0]), point.scene.shear.strain_rate);
    EXPECT_EQ(std::stod(text_of(point.values[0])), point.scene.shear.strain_rate);
  }
  EXPECT_EQ(rates, (std::vector<double>{1e-4, 0.1, 1.2345678901234567e-3, 30e-5}));
}

TEST(SweepExpansion, EachPointIsTheSceneWithItsValues) {
  auto const sweep = expand(R"([sweep]
grid = { "disks.model" = ["CD", "CD_rot"], "integration.time_step" = ["auto", 0.25] })");
  ASSERT_EQ(sweep.points.size(), 4u);
  auto by_hand = parse_scene(base, "by hand", "/",
                             {"disks.model=CD_rot", "integration.time_step=0.25",
                              "integration.scheme=two-stage-leapfrog", "integration.skin=0.35"});
  EXPECT_EQ(write_scene(sweep.points[3].scene), write_scene(by_hand))
      << "scheme and skin are resolved";
  EXPECT_TRUE(sweep.points[0].scene.integration.time_step.number) << "resolved";
  EXPECT_EQ(text_of(sweep.points[0].values[1]), "auto");
}

TEST(SweepExpansion, ARequiredKeyMayStandInTheListAlone) {
  auto scene = base;
  scene.erase(scene.find("elasticity"), std::string("elasticity = 1.0\n").size());
  EXPECT_EQ(expand("[sweep]\ngrid = { \"disks.elasticity\" = [1, 2] }", scene).points.size(), 2u);
}

TEST(SweepExpansion, FoldersAreReadableAndSafe) {
  auto const sweep = expand(R"([sweep]
grid = { "title" = ["a/b ..", "\u03c6\"'$x"], "shear.strain_rate" = [1e-4, 0.01] })");
  std::vector<std::string> names;
  for (auto const& point : sweep.points) names.push_back(point.folder);
  EXPECT_EQ(names[0], "0001_title=a-b-.._strain_rate=0.0001");
  EXPECT_EQ(names[1], "0002_title=a-b-.._strain_rate=0.01");
  for (auto const& name : names)
    EXPECT_EQ(name.find_first_of("/ \"'$\\\n"), std::string::npos) << name;
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 4u);
}

TEST(SweepExpansion, WithoutAChainEveryPointIsOne) {
  auto const sweep = expand("[sweep]\ngrid = { \"disks.seed\" = [1, 2, 3] }");
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0}, {1}, {2}}));
  for (auto const& point : sweep.points) EXPECT_FALSE(point.previous.has_value());
}

TEST(SweepExpansion, AChainRunsAlongItsKey) {
  auto const sweep = expand(R"([sweep]
chain = "shear.strain_rate"
grid = { "shear.strain_rate" = [1e-2, 1e-3], "disks.seed" = [1, 2] })");
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0, 2}, {1, 3}}));
  EXPECT_EQ(sweep.points[0].scene.start.kind, "random");
  EXPECT_EQ(sweep.points[3].previous, 1u);
  EXPECT_EQ(sweep.points[3].scene.start.kind, "state");
  EXPECT_EQ(sweep.points[3].scene.start.file, "../0002_strain_rate=0.01_seed=2/state.h5");
}

/// A start that is relaxed is that of the first point; the others begin in the contacts of a flow.
TEST(SweepExpansion, AChainIsRelaxedWhereItBegins) {
  auto const sweep = expand(R"([start]
kind = "state"
file = "state.h5"
relax = true
[sweep]
chain = "shear.strain_rate"
grid = { "shear.strain_rate" = [1e-2, 1e-3] })");
  EXPECT_TRUE(sweep.points[0].scene.start.relax);
  EXPECT_FALSE(sweep.points[1].scene.start.relax);
  auto const asked = expand(R"([sweep]
chain = "shear.strain_rate"
zip = { "shear.strain_rate" = [1e-2, 1e-3], "start.relax" = [false, true] })");
  EXPECT_FALSE(asked.points[0].scene.start.relax);
  EXPECT_TRUE(asked.points[1].scene.start.relax);
}

TEST(SweepExpansion, AChainAlongZipTakesWholeRows) {
  auto const sweep = expand(R"([sweep]
chain = "shear.strain_rate"
zip = { "shear.strain_rate" = [1e-2, 1e-3, 1e-2], "shear.strain" = [1, 2, 3] }
grid = { "disks.seed" = [1, 2] })");
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0, 2, 4}, {1, 3, 5}}));
}

TEST(SweepExpansion, ARowFromRandomBeginsAnotherChain) {
  auto const sweep = expand(R"([sweep]
chain = "start.copies"
grid = { "disks.seed" = [1, 2] }
[sweep.zip]
"start.kind" = ["random", "state", "random", "state"]
"start.copies" = [false, true, false, true]
"disks.count" = [64, 128, 32, 128]
"disks.box_aspect" = [2, 1, 1, 4])");
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0, 2}, {1, 3}, {4, 6}, {5, 7}}));
  EXPECT_EQ(sweep.points[4].scene.start.kind, "random");
  EXPECT_FALSE(sweep.points[4].previous.has_value());
  EXPECT_EQ(sweep.points[6].previous, 4u);
  EXPECT_TRUE(sweep.points[6].scene.start.copies);
}

/// What is not varied along the chain is where it begins.
TEST(SweepExpansion, AChainBeginsWhereItsGridSays) {
  auto const sweep = expand(R"([sweep]
chain = "shear.strain_rate"
grid = { "start.kind" = ["random"], "shear.strain_rate" = [1e-2, 1e-3] })");
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0, 1}}));
  EXPECT_EQ(sweep.points[0].scene.start.kind, "random");
  EXPECT_EQ(sweep.points[1].scene.start.kind, "state");
}

std::string const cascade = R"([disks]
model = "CD"
count = 64
packing_fraction = 0.8
elasticity = 1.0
mass = "equal"
[shear]
protocol = "cascade"
strain_rates = [1e-2, 1e-3]
strain = [1, 2]
)";

TEST(SweepExpansion, ACascadeIsAChainOfItsRates) {
  auto const sweep = expand("[sweep]\ngrid = { \"disks.seed\" = [1, 2] }", cascade);
  EXPECT_EQ(sweep.keys, (std::vector<std::string>{"disks.seed", "shear.strain_rate"}));
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0, 1}, {2, 3}}));
  ASSERT_EQ(sweep.points.size(), 4u);
  EXPECT_EQ(sweep.points[2].scene.start.kind, "random");
  auto const& last = sweep.points[3];
  EXPECT_EQ(last.folder, "0004_seed=2_strain_rate=0.001");
  EXPECT_EQ(last.name, "point 2 of 2 (disks.seed = 2), rate 0.001");
  EXPECT_EQ(last.previous, 2u);
  EXPECT_EQ(last.scene.start.file, "../0003_seed=2_strain_rate=0.01/state.h5");
  EXPECT_EQ(last.scene.shear.protocol, "steady");
  EXPECT_EQ(last.scene.shear.strain, 2.0);
  EXPECT_EQ(std::get<double>(last.values.at(1)), 1e-3);
}

TEST(SweepExpansion, CascadesOfDifferentRates) {
  auto const sweep = expand(
      "[sweep]\nzip = { \"shear.strain_rates\" = [[1e-2], [1e-2, 1e-3]], \"shear.strain\" = [3, "
      "[4, 5]] }",
      cascade);
  EXPECT_EQ(sweep.chains, (std::vector<std::vector<std::size_t>>{{0}, {1, 2}}));
  EXPECT_EQ(sweep.points[2].scene.shear.strain, 5.0);
}

}  // namespace
}  // namespace bagnold::sweep
