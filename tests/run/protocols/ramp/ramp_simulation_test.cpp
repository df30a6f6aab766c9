// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "src/engine/make_simulation.hpp"
#include "src/run/run_measured.hpp"
#include "src/start/start.hpp"

namespace bagnold {
namespace {

constexpr double low = 1e-3;

Scene scene_of(double packing_fraction, double ramp_rate) {
  Scene scene;
  scene.disks = {"CD_rot", 64, packing_fraction, 2.0, "equal"};
  scene.start.kind = "state";  // no way by 1e-3
  scene.start.file = "given";
  auto& shear = scene.shear;
  shear.protocol = "ramp";
  shear.strain_rate = low;
  shear.strain_rate_high = 1e-2;
  shear.ramp_rate = ramp_rate;
  shear.ramp_window = 10;
  shear.strain = 0.01;
  scene.integration.time_step = 0.05;
  return scene;
}

std::unique_ptr<Simulation> simulate(Scene const& scene, Snapshot const& from) {
  return make_simulation(scene, from, "");
}

/// Far apart on a lattice of eight rows, with the mean flow of the lowest rate.
State lattice(Scene const& scene) {
  State state;
  state.box_length = scene.box_length();
  state.box_aspect = scene.disks.box_aspect;
  double const a = state.box_length / 8, b = state.box_height() / 8;
  for (int i = 0; i < 64; ++i) {
    state.position.push_back({(i % 8 + 0.5) * a, (i / 8 + 0.5) * b});
    state.velocity.push_back({low * state.position.back()[1], 0.0});
    state.spin.push_back(-low / 2);
    state.diameter.push_back(i < 32 ? 1.0 : 1.4);
  }
  return state;
}

Sampling sampling_of(Ramp const& ramp) { return {ramp.window_steps, 10, ramp.steps()}; }

void advance_to(Simulation& simulation, Ramp const& ramp, std::int64_t step, OpenWindows& windows) {
  while (simulation.step() < step)
    simulation.advance(step - simulation.step(), sampling_of(ramp), windows);
}

/// Disks that never touch, in mean flow: v = gammadot(t) y, moved by y times the strain of Eq. (38)
/// summed over P2's steps of tau_e, spins -gammadot(t)/2.
void expect_the_flow_scales(double aspect, char const* engine) {
  Scene scene = scene_of(0.05, 5e-3);
  scene.disks.box_aspect = aspect;
  scene.integration.engine = engine;
  Ramp const ramp = make_ramp(scene);
  auto simulation = simulate(scene, first_snapshot(lattice(scene)));
  OpenWindows windows;
  State const start = lattice(scene);
  for (std::int64_t const wanted : {ramp.slow_steps + 1, ramp.slow_steps + 1234, ramp.steps() / 2,
                                    ramp.steps() - 777, ramp.steps()}) {
    advance_to(*simulation, ramp, wanted, windows);
    std::int64_t const stop = simulation->step();
    if (scene.integration.engine == "auto")
      ASSERT_GE(stop, wanted);
    else
      ASSERT_EQ(stop, wanted);
    State const state = simulation->state();
    double const rate = ramp.piece(std::min(stop, ramp.steps() - 1)).rate;
    long double strain = 0;  // step by step
    for (std::int64_t s = 0; s < stop; ++s)
      strain += static_cast<long double>(ramp.piece(s).rate) * ramp.time_step;
    double const gamma = static_cast<double>(strain), L = state.box_length;
    EXPECT_NEAR(std::remainder(state.offset - gamma * aspect * L, L), 0, 1e-11);
    EXPECT_NEAR(state.time, static_cast<double>(stop) * 0.05, 1e-9);
    EXPECT_EQ(state.strain_rate, rate);
    for (std::size_t i = 0; i < 64; ++i) {
      double const y = start.position[i][1];
      EXPECT_NEAR(state.velocity[i][0], rate * y, 1e-13);
      EXPECT_EQ(state.velocity[i][1], 0);
      EXPECT_NEAR(std::remainder(state.position[i][0] - start.position[i][0] - gamma * y, L), 0,
                  1e-10);
      EXPECT_NEAR(state.spin[i], -rate / 2, 1e-15);
    }
  }
}

TEST(RampSimulation, ScalesTheFlowWithTheRate) {
  for (auto const* engine : {"reference", "few-contacts", "auto"})
    expect_the_flow_scales(1.0, engine);
}

TEST(RampSimulation, ScalesTheFlowInBoxesThatAreNotSquare) {
  for (auto const* engine : {"reference", "few-contacts", "auto"}) {
    expect_the_flow_scales(4.0, engine);
    expect_the_flow_scales(0.25, engine);
  }
}

/// Stopped at any step, taken up again from the snapshot: the same bits.
TEST(RampSimulation, GoesOnBitForBit) {
  Scene scene = scene_of(0.82, 2e-2);
  scene.disks.seed = 5;
  Ramp const ramp = make_ramp(scene);
  constexpr std::pair<char const*, double> cases[] = {
      {"reference", 1.0}, {"auto", 1.0}, {"auto", 3.0}};
  for (auto const& [engine, aspect] : cases) {
    scene.integration.engine = engine;
    scene.disks.box_aspect = aspect;
    auto const start = first_snapshot(random_start(scene).state);
    auto straight = simulate(scene, start);
    OpenWindows all;
    advance_to(*straight, ramp, ramp.steps(), all);
    for (std::int64_t const stop :
         {std::int64_t{1}, ramp.slow_steps - 1, ramp.slow_steps, ramp.slow_steps + 1,
          ramp.slow_steps + 20, ramp.slow_steps + 333, ramp.steps() - 1, ramp.steps()}) {
      auto first = simulate(scene, start);
      OpenWindows windows;
      advance_to(*first, ramp, stop, windows);
      auto second = simulate(scene, first->snapshot());
      EXPECT_EQ(second->step(), first->step());
      advance_to(*second, ramp, ramp.steps(), windows);
      EXPECT_EQ(second->state().position, straight->state().position) << stop;
      EXPECT_EQ(second->state().velocity, straight->state().velocity) << stop;
      EXPECT_EQ(second->state().spin, straight->state().spin) << stop;
      EXPECT_EQ(second->snapshot().initial_offset, start.initial_offset);
      ASSERT_EQ(windows.sums.size(), all.sums.size());
      for (std::size_t w = 0; w < all.sums.size(); ++w)
        EXPECT_EQ(windows.sums[w].sums, all.sums[w].sums);
    }
  }
}

/// Checkpoints of before were those of a simulation of one piece, its lists built where it begins.
TEST(RampSimulation, GoesOnFromASnapshotOfOnePiece) {
  Scene scene = scene_of(0.82, 2e-2);
  Ramp const ramp = make_ramp(scene);
  for (auto const* engine : {"reference", "auto"}) {
    scene.integration.engine = engine;
    auto const whole = simulate(scene, first_snapshot(random_start(scene).state));
    OpenWindows windows;
    auto const piece = ramp.piece(ramp.first_leg() + 333);
    advance_to(*whole, ramp, piece.begin, windows);
    ASSERT_EQ(whole->step(), piece.begin);
    Scene at_rate = scene;
    at_rate.shear.protocol = "steady";
    at_rate.shear.strain_rate = piece.rate;
    Snapshot from = whole->snapshot();
    from.state = whole->state();
    from.list_position.clear();
    double const initial_offset = from.initial_offset;
    double const turns = from.state.offset / from.state.box_length -
                         ramp.time_step * piece.rate * static_cast<double>(piece.begin);
    from.initial_offset = (turns - std::floor(turns)) * from.state.box_length;
    auto const of_piece = make_simulation(at_rate, from, "");
    of_piece->advance(7, {}, windows);
    Snapshot saved = of_piece->snapshot();
    EXPECT_EQ(saved.list_step, piece.begin);
    saved.initial_offset = initial_offset;
    auto const resumed = simulate(scene, saved);
    OpenWindows of_resumed;
    for (std::int64_t const stop : {piece.end + 100, ramp.steps()}) {
      advance_to(*whole, ramp, stop, windows);
      advance_to(*resumed, ramp, stop, of_resumed);
      ASSERT_EQ(resumed->step(), whole->step());
      EXPECT_NEAR(resumed->state().offset, whole->state().offset, 1e-11);
      if (stop == ramp.steps()) continue;  // rounding has grown
      for (std::size_t i = 0; i < 64; ++i)
        EXPECT_NEAR(resumed->state().velocity[i][1], whole->state().velocity[i][1], 1e-11);
    }
  }
}

/// All mean rates of windows and the number of evaluations: none is lost or seen twice where rates
/// change.
TEST(RampSimulation, WindowsHoldTheirEvaluations) {
  Scene const scene = scene_of(0.82, 2e-2);
  Plan const plan = make_plan(scene);
  auto simulation = simulate(scene, first_snapshot(random_start(scene).state));
  Measurement measurement{{static_cast<std::size_t>(simulation->columns()), {}, {}}, {}, Frames{}};
  EXPECT_TRUE(run_measured(*simulation, plan, measurement, [] { return true; }));
  ASSERT_EQ(static_cast<std::int64_t>(measurement.windows.size()), plan.windows);
  for (double const weight : measurement.windows.weight)
    EXPECT_EQ(weight, 20);  // 200 steps, every 10
}

/// Finer pieces come to the same end: with pieces of T the flow is behind Eq. (38) by half of kappa
/// T, so that differences fall with T.
TEST(RampSimulation, ConvergesInThePieces) {
  auto const strain_with = [](double every) {
    Scene scene = scene_of(0.82, 1e-3);
    scene.shear.ramp_every = every;
    Ramp const ramp = make_ramp(scene);
    return static_cast<double>(ramp.strain(ramp.first_leg() + ramp.leg_steps()) -
                               ramp.strain(ramp.first_leg()));
  };
  double const exact = low * (10 - 1) / (1e-3 * std::log(10.0));  // of Eq. (38) itself
  double const coarse = strain_with(10) / exact - 1, fine = strain_with(1) / exact - 1;
  EXPECT_NEAR(fine, -std::log(10.0) * 1e-3 / 2, 1e-6);
  EXPECT_NEAR(coarse / fine, 10, 0.2);
}

}  // namespace
}  // namespace bagnold
