// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/config/errors.hpp"
#include "src/start/deep_overlaps.hpp"
#include "src/start/start.hpp"

namespace bagnold {
namespace {

Scene crowded_scene() {
  Scene scene;
  scene.disks.model = "CD_rot";
  scene.disks.count = 200;
  scene.disks.packing_fraction = 0.78;
  scene.disks.elasticity = 1;
  scene.shear.strain_rate = 1e-2;
  scene.start.kind = "state";
  scene.start.file = "/folder/state.h5";
  scene.start.relax = true;
  return scene;
}

/// On a lattice that knows nothing of diameters, sheared by a third of the box, with motions
/// beyond the mean flow.
StartedState crowded(Scene const& scene) {
  StartedState started;
  State& state = started.state;
  state.box_length = scene.box_length();
  state.offset = state.box_length / 3;
  for (std::size_t i = 0; i < 200; ++i) {
    auto const k = static_cast<double>(i);
    double const x = state.box_length * (static_cast<double>(i % 20) + 0.3) / 20;
    double const y = state.box_length * (static_cast<double>(i / 20) + 0.01) / 10;
    state.position.push_back({x, y});
    state.velocity.push_back({1e-2 * y + 1e-3 * std::sin(k), 1e-3 * std::cos(3 * k)});
    state.spin.push_back(1e-3 * k);
    state.diameter.push_back(i % 2 == 0 ? 1.4 : 1.0);
  }
  return started;
}

TEST(RelaxState, PushesDisksApartAndKeepsTheirMotion) {
  Scene const scene = crowded_scene();
  StartedState started = crowded(scene);
  State const before = started.state;
  ASSERT_GT(deep_overlaps(before, 0.1).pairs, 50);
  relax_state(started, scene);
  State const& after = started.state;
  EXPECT_EQ(deep_overlaps(after, 1.001 * scene.start.overlap).pairs, 0);
  EXPECT_LE(started.record.at("start_overlap"), scene.start.overlap);
  EXPECT_GT(started.record.at("start_iterations"), 10);
  EXPECT_EQ(after.offset, before.offset);
  EXPECT_EQ(after.spin, before.spin);
  for (std::size_t i = 0; i < before.count(); ++i) {
    EXPECT_NEAR(after.velocity[i][0] - 1e-2 * after.position[i][1],
                before.velocity[i][0] - 1e-2 * before.position[i][1], 1e-15);
    EXPECT_EQ(after.velocity[i][1], before.velocity[i][1]);
  }
  StartedState again{after, {}};
  relax_state(again, scene);
  EXPECT_EQ(again.record.at("start_iterations"), 0);
  EXPECT_EQ(again.state.position, after.position);
}

TEST(RelaxState, SaysWhereTooLittleWasDone) {
  Scene scene = crowded_scene();
  scene.start.iterations = 1;
  StartedState started = crowded(scene);
  try {
    relax_state(started, scene);
    ADD_FAILURE() << "went on";
  } catch (NumericalError const& error) {
    std::string const message = error.what();
    for (auto const* part : {"/folder/state.h5", "start.iterations = 1", "limit 5%"})
      EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
  }
}

}  // namespace
}  // namespace bagnold
