// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/start/start_from_state.hpp"

namespace bagnold {
namespace {

/// Fits scene_from_state, disks in an order that no random start has; made at the scene's rate, or
/// another one, and at rest on average against its flow.
State some_state(double rate = 3e-3) {
  State state;
  for (int i = 0; i < 20; ++i) {
    double const x = i;
    state.position.push_back({0.3 + 0.2 * x, 5 - 0.1 * x});
    double const fluctuation = i < 10 ? 1 + 0.1 * x : -1 - 0.1 * (x - 10);  // sum: 0
    state.velocity.push_back({rate * state.position.back()[1] + 1e-3 * fluctuation,
                              i % 3 == 0 && i < 18 ? 2e-3 * (i % 6 == 0 ? 1 : -1) : 0});
    state.spin.push_back(-1e-3 + 1e-4 * x);
    state.diameter.push_back(i % 2 == 0 ? 1.4 : 1.0);
  }
  state.box_length = scene_from_state("CD").box_length();
  state.offset = 1.25;
  state.time = 77;
  state.strain_rate = rate;
  return state;
}

/// Of a scene without replicas.
StartedState fit(State state, Scene const& scene) {
  return fit_to_scene({std::move(state)}, scene).front();
}

/// The message with which a spoilt state is refused as bad input; "accepted" if it is not.
std::string refusal(std::function<void(State&)> const& spoil,
                    Scene scene = scene_from_state("CD_rot")) {
  State state = some_state();
  spoil(state);
  return refusal({state}, scene);
}

TEST(FitToScene, KeepsEveryBitAtTheSameRate) {
  for (auto const* model : {"CD_rot", "CD_nt"}) {
    auto const started = fit(some_state(), scene_from_state(model));
    State const expected = some_state();
    EXPECT_EQ(started.state.position, expected.position);
    EXPECT_EQ(started.state.velocity, expected.velocity);
    EXPECT_EQ(started.state.spin, expected.spin);
    EXPECT_EQ(started.state.diameter, expected.diameter);
    EXPECT_EQ(started.state.box_length, expected.box_length);
    EXPECT_EQ(started.state.offset, 1.25);
    EXPECT_EQ(started.state.time, 77);
    EXPECT_EQ(started.state.strain_rate, 3e-3);
    EXPECT_TRUE(started.record.empty());
  }
}

/// P2 Eqs. (40)-(41): v and thetadot are multiplied by the ratio of the rates.
TEST(FitToScene, ScalesToAnotherRate) {
  State const state = some_state(6e-3);
  auto const started = fit(state, scene_from_state("CD_rot"));
  for (std::size_t i = 0; i < state.count(); ++i) {
    for (int a = 0; a < 2; ++a)
      EXPECT_DOUBLE_EQ(started.state.velocity[i][a], state.velocity[i][a] / 2);
    EXPECT_DOUBLE_EQ(started.state.spin[i], state.spin[i] / 2);
  }
  EXPECT_EQ(started.state.position, state.position);
  EXPECT_EQ(started.state.strain_rate, 3e-3);
  EXPECT_DOUBLE_EQ(started.record.at("start_velocity_scale"), 0.5);
}

TEST(FitToScene, RescalingCanBeTurnedOff) {
  Scene scene = scene_from_state("CD_rot");
  scene.start.rescale = false;
  for (double const rate : {6e-3, -1.0, 0.0}) {
    State state = some_state();
    state.strain_rate = rate;
    auto const started = fit(state, scene);
    EXPECT_EQ(started.state.velocity, state.velocity);
    EXPECT_EQ(started.state.spin, state.spin);
    EXPECT_EQ(started.state.strain_rate, 3e-3);
    EXPECT_EQ(started.record.count("start_velocity_scale"), 0u);
  }
}

TEST(FitToScene, AStateWithoutARateIsKept) {
  State state = some_state();
  state.strain_rate.reset();
  auto const started = fit(state, scene_from_state("CD_rot"));
  EXPECT_EQ(started.state.velocity, state.velocity);
  EXPECT_EQ(started.state.spin, state.spin);
  EXPECT_EQ(started.state.strain_rate, 3e-3);
}

TEST(FitToScene, MissingSpinsAreThoseOfTheFlowAndRecorded) {
  State state = some_state();
  state.spin.clear();
  auto started = fit(state, scene_from_state("CD_rot"));
  EXPECT_EQ(started.state.spin, std::vector<double>(20, -1.5e-3));
  EXPECT_EQ(started.record.at("start_spins_assumed"), 1);
  state = some_state(6e-3);  // scaled with the velocities: those of the new flow
  state.spin.clear();
  started = fit(state, scene_from_state("CD_rot"));
  ASSERT_EQ(started.state.spin.size(), 20u);
  for (double const spin : started.state.spin) EXPECT_DOUBLE_EQ(spin, -1.5e-3);
}

TEST(FitToScene, SpinsAreDroppedWhereTheLawHasNone) {
  for (auto const* model : {"CD", "CD_n"}) {
    auto const started = fit(some_state(), scene_from_state(model));
    EXPECT_TRUE(started.state.spin.empty());
    EXPECT_TRUE(started.record.empty());
  }
}

TEST(FitToScene, DisagreementsAreRefusedByName) {
  EXPECT_EQ(refusal([](State&) {}), "accepted");
  EXPECT_TRUE(names(refusal([](State& s) {
                      for (auto* column : {&s.position, &s.velocity}) column->resize(18);
                      s.spin.resize(18);
                      s.diameter.resize(18);
                    }),
                    {"/folder/state.h5", "18 disks", "disks.count = 20"}));
  EXPECT_TRUE(names(refusal([](State& s) {
                      for (auto* column : {&s.position, &s.velocity}) column->resize(19);
                      s.spin.resize(19);
                      s.diameter.resize(19);
                    }),
                    {"/folder/state.h5", " of 19 disks are small", "no disks.count fits"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.diameter[7] = 1.2; }),
                    {"/folder/state.h5", "diameter[7] = 1.2"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.diameter[7] = 1 + 1e-8; }), {"diameter[7]"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.diameter[2] = NAN; }), {"diameter[2]"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.diameter[1] = 1.4; }),
                    {"/folder/state.h5", "9 of 20 disks are small"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.box_length *= 1 + 3e-9; }),
                    {"/folder/state.h5", "box_length", "disks.packing_fraction = 0.7"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.box_length *= 1 - 3e-9; }), {"box_length"}));
  EXPECT_TRUE(names(refusal([](State& s) { s.box_length = NAN; }), {"box_length"}));
  for (double const aspect : {2.0, 0.5, 1 + 3e-9, 0.0, std::nan("")})
    EXPECT_TRUE(names(refusal([=](State& s) { s.box_aspect = aspect; }),
                      {"/folder/state.h5", "box_aspect = ", "disks.box_aspect = 1 "}));
  for (double const rate : {0.0, -6e-3})
    EXPECT_TRUE(names(refusal([=](State& s) { s.strain_rate = rate; }),
                      {"/folder/state.h5", "strain_rate = ", "start.rescale"}));
}

/// States that differ, as the last ones of replicas do.
std::vector<State> some_states(std::size_t count) {
  std::vector<State> states(count, some_state());
  for (std::size_t r = 0; r < count; ++r) states[r].position[3][0] += 1e-3 * static_cast<double>(r);
  return states;
}

std::string refusal_of_states(std::vector<State> const& states, std::int64_t replicas) {
  Scene scene = scene_from_state("CD_rot");
  scene.disks.replicas = replicas;
  return refusal(states, scene);
}

TEST(FitToScene, EachReplicaNeedsAStateOfItsOwn) {
  EXPECT_EQ(refusal_of_states(some_states(3), 3), "accepted");
  EXPECT_TRUE(names(
      refusal_of_states(some_states(1), 3),
      {"/folder/state.h5", "holds 1 state,", "disks.replicas = 3", "set disks.replicas = 1"}));
  EXPECT_TRUE(names(refusal_of_states(some_states(3), 1),
                    {"holds 3 states", "disks.replicas = 1", "set disks.replicas = 3"}));
  EXPECT_TRUE(names(refusal_of_states(some_states(2), 3), {"holds 2 states"}));
  auto states = some_states(3);
  states[2] = states[0];
  EXPECT_TRUE(names(refusal_of_states(states, 3), {"states 0 and 2", "the same", "seed"}));
  for (auto& v : states[2].velocity) v = {v[0] + 0.02, v[1] - 0.01};  // it is taken off
  EXPECT_TRUE(names(refusal_of_states(states, 3), {"states 0 and 2", "the same"}));
  states[2].velocity[0][0] += 1;
  EXPECT_EQ(refusal_of_states(states, 3), "accepted");
}

TEST(FitToScene, EachStateIsFitted) {
  Scene scene = scene_from_state("CD_rot");
  scene.disks.replicas = 2;
  auto states = some_states(2);
  states[1] = some_state(6e-3);
  auto const started = fit_to_scene(states, scene);
  ASSERT_EQ(started.size(), 2u);
  EXPECT_EQ(started[0].state.velocity[1], states[0].velocity[1]);
  EXPECT_EQ(started[1].state.velocity[1][0], states[1].velocity[1][0] / 2);
  EXPECT_EQ(started[1].state.position, states[1].position);
  states[1].diameter[2] = 1.2;
  EXPECT_TRUE(names(refusal_of_states(states, 2), {"diameter[2]"}));
}

/// Diameters and box to 1e-9: what the file says of the box is used.
TEST(FitToScene, SmallDisagreementsAreNone) {
  EXPECT_EQ(refusal([](State& s) { s.diameter[1] = 1 + 1e-10; }), "accepted");
  State state = some_state();
  state.box_length *= 1 + 5e-10;
  EXPECT_EQ(fit(state, scene_from_state("CD")).state.box_length, state.box_length);
}

}  // namespace
}  // namespace bagnold
