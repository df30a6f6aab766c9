// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/mean_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kernels/physics/species.hpp"
#include "tests/start/start_from_state.hpp"

namespace bagnold {
namespace {

constexpr double rate = 3e-3;

Scene scene_of(std::string const& mass, std::int64_t count = 20) {
  Scene scene = scene_from_state("CD_rot");
  scene.disks.mass = mass;
  scene.disks.count = count;
  return scene;
}

/// 20 disks anywhere in the shear flow of a rate, with velocities of their own, the big ones faster
/// on average; and all of them faster by `all`.
State moving(double strain_rate, std::array<double, 2> all) {
  State state;
  state.box_length = scene_of("equal").box_length();
  state.offset = 0.4 * state.box_length;
  state.strain_rate = strain_rate;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> in_box(0, state.box_length);
  for (int i = 0; i < 20; ++i) {
    bool const big = i % 2 == 0;
    state.position.push_back({in_box(random), in_box(random)});
    state.velocity.push_back(
        {strain_rate * (state.position.back()[1] + normal(random) + big) + all[0],
         strain_rate * (normal(random) - big) + all[1]});
    state.spin.push_back(-strain_rate / 2);
    state.diameter.push_back(big ? 1.4 : 1.0);
  }
  return state;
}

/// sum m (v - gammadot y x^) / sum m, written out: m = (pi/2) d^2 of P1, or 1 of P2.
std::array<double, 2> momentum_per_mass(State const& state, std::string const& mass) {
  double masses = 0;
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const d = state.diameter[i], m = mass == "area" ? std::numbers::pi / 2 * d * d : 1;
    masses += m;
    sum[0] += m * (state.velocity[i][0] - rate * state.position[i][1]);
    sum[1] += m * state.velocity[i][1];
  }
  return {sum[0] / masses, sum[1] / masses};
}

void expect_no_mean(State const& state, std::string const& mass) {
  for (double const u : momentum_per_mass(state, mass)) EXPECT_NEAR(u, 0, 1e-15) << mass;
}

std::size_t recorded(StartedState const& started) {
  return started.record.count("start_mean_velocity_x") +
         started.record.count("start_mean_velocity_y") +
         started.record.count("start_mean_motion_share");
}

TEST(MeanMotion, IsThatOfAllMasses) {
  for (std::string const mass : {"equal", "area"}) {
    State const state = moving(rate, {0.02, -0.01});
    auto const found = mean_motion(state, scene_of(mass));
    auto const expected = momentum_per_mass(state, mass);
    EXPECT_NEAR(found.velocity[0], expected[0], 1e-15);
    EXPECT_NEAR(found.velocity[1], expected[1], 1e-15);
    State rest = state;  // of the energy about the mean, what is missing
    take_off_mean_motion(rest, scene_of(mass));
    auto const energy = [&](State const& of) {
      double sum = 0;
      for (std::size_t i = 0; i < of.count(); ++i)
        sum += disk_mass(mass == "area", of.diameter[i]) *
               (std::pow(of.velocity[i][0] - rate * of.position[i][1], 2) +
                std::pow(of.velocity[i][1], 2));
      return sum;
    };
    EXPECT_NEAR(found.share, 1 - energy(rest) / energy(state), 1e-12);
    EXPECT_GT(found.share, 0.5);
  }
}

/// At every start from a file, along and across the flow, with the masses of the scene.
TEST(MeanMotion, IsTakenOffAtEveryStart) {
  for (std::string const mass : {"equal", "area"}) {
    Scene const plain = scene_of(mass);
    Scene kept = plain, many = scene_of(mass, 80);
    kept.start.rescale = false;
    many.start.copies = true;
    State without_rate = moving(rate, {0.02, -0.01}), at_rest = without_rate;
    without_rate.strain_rate.reset();
    at_rest.strain_rate.reset();
    at_rest.velocity.assign(20, {0, 0});
    for (auto const& scene : {plain, kept, many})
      for (auto const& state :
           {moving(rate, {0.02, -0.01}), moving(4 * rate, {0.1, 0}), moving(rate, {0, 1e-4}),
            moving(rate, {0, 0}), without_rate, at_rest}) {
        auto const started = fit_to_scene({state}, scene).front();
        expect_no_mean(started.state, mass);
        EXPECT_EQ(recorded(started), 3u);
        EXPECT_TRUE(started.mean_motion);
      }
  }
}

/// A fluid takes it off by itself, and a bath gives one.
TEST(MeanMotion, IsLeftToADrive) {
  State const state = moving(rate, {0.02, -0.01});
  Scene scene = scene_of("equal");
  for (std::string const kind : {"stokes", "thermal"}) {
    scene.drive.kind = kind;
    auto const started = fit_to_scene({state}, scene).front();
    EXPECT_EQ(started.state.velocity, state.velocity);
    EXPECT_EQ(recorded(started), 0u);
    EXPECT_FALSE(started.mean_motion);
  }
}

/// What disks do against each other stays: the start is that of the state without its mean.
TEST(MeanMotion, IsAllThatIsTakenOff) {
  Scene scene = scene_of("area");
  auto const expected = fit_to_scene({moving(rate, {0, 0})}, scene).front().state;
  auto const found = fit_to_scene({moving(rate, {0.02, -0.01})}, scene).front();
  for (std::size_t i = 0; i < 20; ++i)
    for (int a = 0; a < 2; ++a)
      EXPECT_NEAR(found.state.velocity[i][a], expected.velocity[i][a], 1e-16);
  EXPECT_EQ(found.state.position, expected.position);
  EXPECT_EQ(found.state.spin, expected.spin);
  auto const all = momentum_per_mass(moving(rate, {0.02, -0.01}), "area");
  EXPECT_NEAR(found.record.at("start_mean_velocity_x"), all[0], 1e-15);
  EXPECT_NEAR(found.record.at("start_mean_velocity_y"), all[1], 1e-15);
}

TEST(MeanMotion, OfReplicasOneOfWhichHasAny) {
  Scene scene = scene_of("equal");
  scene.disks.replicas = 2;
  State still = moving(rate, {0, 0});
  take_off_mean_motion(still, scene);
  State other = moving(rate, {0.02, 0});
  other.position[3][0] += 0.01;
  auto const started = fit_to_scene({still, other}, scene);
  EXPECT_EQ(started[0].state.velocity, still.velocity);
  expect_no_mean(started[1].state, "equal");
  for (auto const& one : started) EXPECT_EQ(recorded(one), 3u);  // a row of two in result.h5
  EXPECT_EQ(started[0].record.at("start_mean_motion_share"), 0);
  EXPECT_GT(started[1].record.at("start_mean_motion_share"), 0.5);
}

/// Of a state that has none but by rounding no bit is changed: of one's own, and of disks that move
/// with the shear flow.
TEST(MeanMotion, ThatIsRoundingIsLeft) {
  for (std::string const mass : {"equal", "area"}) {
    Scene const scene = scene_of(mass);
    State state = moving(rate, {0.02, -0.01});
    ASSERT_TRUE(take_off_mean_motion(state, scene));
    State affine = state;
    for (std::size_t i = 0; i < 20; ++i) affine.velocity[i] = {rate * state.position[i][1], 0};
    affine.velocity[3][0] += 1e-18;
    for (auto const& none : {state, affine}) {
      auto const started = fit_to_scene({none}, scene).front();
      EXPECT_EQ(started.state.velocity, none.velocity);
      EXPECT_EQ(recorded(started), 0u);
      EXPECT_FALSE(started.mean_motion);
    }
    State other = state;  // without a mean, but with other masses
    EXPECT_TRUE(take_off_mean_motion(other, scene_of(mass == "area" ? "equal" : "area")));
  }
}

}  // namespace
}  // namespace bagnold
