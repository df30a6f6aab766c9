// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tests/support/events.hpp"

namespace bagnold::test {
namespace {

class EventClusters : public testing::TestWithParam<std::string> {};

/// Three disks that touch in a row or each other, and one that is far from all.
State three_disks(Scene const& scene, bool triangle) {
  State state = flying_start(scene);
  double const middle = state.box_length / 2, speed = 10 * slow_rate;
  state.diameter = {1, 1.4, 1, 1.4};
  double const to_first = 1.198, to_third = 1.197, between = 0.999;
  state.position[1] = {middle, middle};
  state.position[0] = {middle - to_first, middle};
  state.position[2] = {middle + to_third * std::cos(0.3), middle + to_third * std::sin(0.3)};
  state.position[3] = {middle, 1};
  state.velocity = {{2 * speed, 0.3 * speed}, {0, 0}, {-speed, 0.1 * speed}, {0, 0}};
  if (triangle) {
    double const x =
        (to_first * to_first + to_third * to_third - between * between) / (2 * to_first);
    state.position[2] = {middle - x, middle + std::sqrt(to_third * to_third - x * x)};
    state.velocity[2] = {0.5 * speed, -speed};
  }
  for (auto& spin : state.spin) spin = 0.2 * speed;
  return state;
}

}  // namespace

/// Steps of all disks converge to the series, of second order in their length while nothing begins
/// or ends.
TEST_P(EventClusters, OfThreeDisksAreTheLimitOfShortSteps) {
  for (bool const triangle : {false, true})
    for (double const elasticity : {1.5, 20.0}) {
      Scene const scene = dilute_scene(GetParam(), 0.03, 4, elasticity);
      State const start = three_disks(scene, triangle);
      auto const events = simulate_events(scene, start);
      double const time = 1.2;
      advance(*events, std::llround(time / time_step(scene)));
      EXPECT_GT(events->snapshot().counters.at("cluster_steps"), 1);
      EXPECT_EQ(known_contacts(*events, scene.rotates()).size(), triangle ? 3 : 2);
      std::vector<double> off;
      for (double const dt : {0.04, 0.02, 0.01, 0.005}) {
        auto const plain = simulate_events(in_steps(scene, dt), start);
        advance(*plain, std::llround(time / dt));
        off.push_back(distance_between(events->state(), plain->state()));
      }
      EXPECT_LT(off[1], 0.3 * off[0]) << triangle << " " << elasticity;
      EXPECT_LT(off[3], 2e-8) << triangle << " " << elasticity;  // they move by 1e-3
    }
}

/// Where most collisions are busy, too.
TEST_P(EventClusters, KeepTheEnergyBalance) {
  for (double const elasticity : {1.2, 5.0}) {
    Scene const scene = dilute_scene(GetParam(), 0.78, 144, elasticity);
    auto const events = simulate_events(scene, flying_start(scene));
    auto const before = events->state();
    auto const sums = advance(*events, 5000).sums;
    EXPECT_GT(events->snapshot().counters.at("busy_collisions"), 100);
    EXPECT_NEAR(energy_gap(scene, before, sums, events->state()), 0, 3e-5) << elasticity;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EventClusters, testing::Values("CD", "CD_n", "CD_rot", "CD_nt"),
                         [](auto const& info) { return info.param; });

}  // namespace bagnold::test
