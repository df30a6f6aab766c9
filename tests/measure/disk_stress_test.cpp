// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/disk_stress.hpp"

#include <numeric>

#include "kernels/physics/type_list.hpp"
#include "src/config/schemes.hpp"
#include "src/measure/profiles.hpp"
#include "tests/measure/states.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// Sums of disks, and profiles, of a configuration against what an engine adds to those of the box
/// in the step that begins there.
void expect_the_boxs(Scene const& scene) {
  using C = SumColumns;
  auto const simulation = simulate(scene, shaken_start(scene), backend_names().front());
  advance(*simulation, 150);
  State const state = simulation->state();
  auto const of_disks = disk_stress(scene, state);
  Profiles profiles(scene, Slices(state.box_length, state.box_height()));
  profiles.add({state, 150, 0.0});
  FrameResults results;
  profiles.report({&profiles}, results);

  auto const box = advance(*simulation, 1, 1).sums;
  ASSERT_GT(box[C::contacts], 100);
  for (int c = C::elastic_xx; c <= C::contacts; ++c) {
    if (c >= C::kinetic_xx && c <= C::kinetic_yy) continue;
    double sum = 0, size = 0;
    for (auto const& disk : of_disks) {
      sum += disk.value[c];
      size += std::abs(disk.value[c]);
    }
    EXPECT_NEAR(sum, box[c], 1e-10 * size) << "column " << c;
  }
  double const area = state.box_length * state.box_height();
  auto const mean_of = [&](char const* name) {
    auto const& values = named(results.profiles, name).value;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  auto const near = [&](char const* name, double value) {
    EXPECT_NEAR(mean_of(name), value / area, 1e-10 * std::abs(value / area)) << name;
  };
  near("sigma_el", -box[C::elastic_xy]);
  near("sigma_dis", -box[C::dissipative_xy]);
  near("p_el", (box[C::elastic_xx] + box[C::elastic_yy]) / 2);
  near("p_dis", (box[C::dissipative_xx] + box[C::dissipative_yy]) / 2);
}

TEST(DiskStress, AddsUpToThatOfTheBox) {
  for (auto const& law : law_names())
    for (auto const scheme : names_of<Schemes>())
      for (char const* engine : {"reference", "many-contacts"}) {
        SCOPED_TRACE(law + " " + std::string(scheme) + " " + engine);
        Scene scene = small_scene(law, 0.84, 200);
        scene.integration.scheme = scheme;
        scene.integration.engine = engine;
        expect_the_boxs(scene);
      }
}

TEST(DiskStress, AddsUpToThatOfABoxThatIsNotSquare) {
  for (double const aspect : {4.0, 0.25}) {
    SCOPED_TRACE(aspect);
    Scene scene = small_scene("CD_rot", 0.84, 200);
    scene.disks.box_aspect = aspect;
    scene.integration.scheme = two_stage_scheme;
    expect_the_boxs(scene);
  }
}

TEST(DiskStress, AddsUpToThatOfTheBoxForHertzianDisks) {
  Scene scene = small_scene("CD_rot", 0.84, 200);
  scene.disks.force_exponent = 2.5;
  scene.integration.scheme = two_stage_scheme;
  expect_the_boxs(scene);
}

}  // namespace
}  // namespace bagnold::test
