// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/paper_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

Scene scene_of(std::string const& model, std::string const& mass, double phi, double q) {
  Scene scene = minimal_scene();
  scene.disks.model = model;
  scene.disks.mass = mass;
  scene.disks.packing_fraction = phi;
  scene.disks.elasticity = q;
  return scene;
}

std::vector<PaperValue> values_of(Scene const& scene) {
  return paper_values(scene, observables(scene, scene.box_length()));
}

/// The quantities stated for a scene, each once.
std::vector<std::string> stated(Scene const& scene) {
  std::vector<std::string> names;
  for (auto const& value : values_of(scene)) names.push_back(value.quantity);
  return names;
}

using Names = std::vector<std::string>;

/// P1 Sec. III A: B_p^kin/B_p roughly 10% at phi = 0.60, 0.1-0.5% at 0.835; P1 Appendix: delta p/p
/// 5-12% at the smaller phi for Q below about 10.
TEST(PaperValues, OfP1BelongToItsModelAndMasses) {
  EXPECT_EQ(stated(scene_of("CD_n", "area", 0.60, 1)), (Names{"p_kin/p", "delta_p/p"}));
  EXPECT_EQ(stated(scene_of("CD_n", "area", 0.60, 50)), (Names{"p_kin/p"}));
  EXPECT_EQ(stated(scene_of("CD_n", "area", 0.835, 1)), (Names{"p_kin/p", "|sigma_kin|/sigma"}));
  EXPECT_EQ(stated(scene_of("CD_n", "area", 0.65, 2)), (Names{"delta_p/p"}));
  EXPECT_EQ(stated(scene_of("CD_n", "area", 0.78, 1)), Names{});
  EXPECT_EQ(stated(scene_of("CD_n", "area", 0.601, 50)), Names{});
  for (auto const* model : {"CD_n", "CD", "CD_nt"})
    EXPECT_EQ(stated(scene_of(model, "equal", 0.60, 1)), Names{}) << model;
  for (auto const* model : {"CD", "CD_nt"})
    EXPECT_EQ(stated(scene_of(model, "area", 0.60, 1)), Names{}) << model;
}

TEST(PaperValues, OfTheTwoSharesDiffer) {
  EXPECT_EQ(values_of(scene_of("CD_n", "area", 0.60, 50)).at(0).stated, "about 0.10");
  EXPECT_EQ(values_of(scene_of("CD_n", "area", 0.835, 1)).at(0).stated, "0.001 to 0.005");
}

/// P2: <thetadot/gammadot> about -1/2 wherever disks rotate; P = 2e-5 and mu = 0.346 where bands
/// coexist, for N = 65536 and Q = 1 only.
TEST(PaperValues, OfP2BelongToTheBands) {
  EXPECT_EQ(stated(scene_of("CD_rot", "equal", 0.82, 1)), Names{"spin_mean"});
  struct Point {
    double phi, rate;
  };
  for (auto const point : {Point{0.7984, 3e-5}, Point{0.792, 5e-5}, Point{0.802, 2e-5}}) {
    Scene scene = scene_of("CD_rot", "equal", point.phi, 1);
    scene.shear.strain_rate = point.rate;
    EXPECT_EQ(stated(scene), Names{"spin_mean"}) << "N = 1024";
    scene.disks.count = 65536;
    EXPECT_EQ(stated(scene), (Names{"spin_mean", "p", "mu"}));
    EXPECT_EQ(values_of(scene).at(1).stated, "2e-5");
    EXPECT_EQ(values_of(scene).at(2).stated, "0.346");
    scene.disks.elasticity = 2;
    EXPECT_EQ(stated(scene), Names{"spin_mean"});
    scene.disks.elasticity = 1;
    scene.shear.strain_rate = 1e-4;
    EXPECT_EQ(stated(scene), Names{"spin_mean"});
    scene.shear.strain_rate = point.rate;
    scene.disks.model = "CD";
    EXPECT_EQ(stated(scene), Names{});
  }
}

/// What stands beside a stated number is that quantity, of our averages.
TEST(PaperValues, TakeOursFromTheObservables) {
  std::vector<double> averages;
  for (int k = 0; k < 15; ++k) averages.push_back(1.0 + 0.37 * k * k);
  Scene banded = scene_of("CD_rot", "equal", 0.802, 1);
  banded.disks.count = 65536;
  banded.shear.strain_rate = 2e-5;
  for (auto const& scene : {scene_of("CD_n", "area", 0.60, 1), banded}) {
    auto const list = observables(scene, scene.box_length());
    auto const ours = [&](std::string const& name) {
      return std::find_if(list.begin(), list.end(), [&](auto const& o) { return o.name == name; })
          ->value(averages);
    };
    for (auto const& value : paper_values(scene, list)) {
      auto const slash = value.quantity.find('/');
      double const expected =
          slash == std::string::npos
              ? ours(value.quantity)
              : ours(value.quantity.substr(0, slash)) / ours(value.quantity.substr(slash + 1));
      EXPECT_EQ(value.value(averages), expected) << value.quantity;
      EXPECT_FALSE(value.source.empty());
    }
  }
}

}  // namespace
}  // namespace bagnold
