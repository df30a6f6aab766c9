// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/auto_scheme/auto_scheme.hpp"

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/errors.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/time_step.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A dense flow of CD or CD_rot at 1e-4.
Scene dense_flow(std::string const& model) {
  Scene scene;
  scene.disks.model = model;
  scene.disks.count = 128;
  scene.disks.packing_fraction = 0.84;
  scene.disks.elasticity = 1.0;
  scene.shear.strain_rate = 1e-4;
  scene.integration.scheme = automatic;
  scene.integration.accuracy = 0.005;  // all methods, finer ones with them
  return scene;
}

struct Stepped {
  Snapshot last;
  std::vector<WindowSums> windows;
};

bool same(std::vector<WindowSums> const& a, std::vector<WindowSums> const& b) {
  return std::ranges::equal(a, b, [](WindowSums const& one, WindowSums const& other) {
    return one.weight == other.weight && one.sums == other.sums;
  });
}

/// Steps through methods, one for each place of the grid, in calls of `piece` steps; `resumed`:
/// through a snapshot after each.
Stepped stepped(Scene const& scene, Snapshot from, std::vector<std::size_t> const& methods,
                std::int64_t piece, bool resumed = false) {
  auto const ladder = ladder_of(scene);
  auto const end = std::ssize(methods) * ladder.grid;
  Sampling const sampling{
      .window_steps = ladder.window, .every = scene.measure.every, .last_step = end};
  OpenWindows windows;
  auto simulation = make_simulation(scene, std::move(from), "serial");
  for (std::size_t k = 0; k < methods.size(); ++k) {
    simulation->take_method(methods[k]);
    auto const place = static_cast<std::int64_t>(k + 1) * ladder.grid;
    while (simulation->step() < place) {
      simulation->advance(std::min(piece, place - simulation->step()), sampling, windows);
      if (resumed) simulation = make_simulation(scene, simulation->snapshot(), "serial");
    }
    EXPECT_EQ(simulation->step(), place);
  }
  return {simulation->snapshot(), windows.sums};
}

double pressure(WindowSums const& window) {
  using C = SumColumns;
  double sum = 0;
  for (int const c : {C::elastic_xx, C::elastic_yy, C::dissipative_xx, C::dissipative_yy})
    sum += window.sums[c];
  return sum / window.weight;
}

}  // namespace

/// The same bits however it is cut, whichever methods follow each other.
TEST(AutoScheme, GoesOnBitForBit) {
  for (auto const* model : {"CD", "CD_rot"}) {
    Scene const scene = dense_flow(model);
    auto const ladder = ladder_of(scene);
    std::vector<std::size_t> const methods = {ladder.usual, 0, 0, ladder.usual, ladder.usual + 1};
    Snapshot const start = first_snapshot(random_start(scene).state);
    auto const whole = stepped(scene, start, methods, 1 << 20);
    EXPECT_EQ(whole.last.counters.at("steps_by_implicit_damping"), 2 * ladder.grid);
    EXPECT_EQ(whole.last.counters.at("steps_in_parts"), ladder.grid);
    for (auto const& [piece, resumed] :
         {std::pair{std::int64_t{100}, false}, {ladder.grid / 3, true}}) {
      auto const cut = stepped(scene, start, methods, piece, resumed);
      EXPECT_EQ(cut.last.state.position, whole.last.state.position) << model << resumed;
      EXPECT_EQ(cut.last.state.velocity, whole.last.state.velocity) << model << resumed;
      EXPECT_EQ(cut.last.memory, whole.last.memory) << model << resumed;
      EXPECT_TRUE(same(cut.windows, whole.windows)) << model << resumed;
    }
  }
}

/// From one state all methods have the stress of two stages, window by window.
TEST(AutoScheme, AllMethodsFollowOneFlow) {
  for (auto const* model : {"CD", "CD_rot"}) {
    Scene scene = dense_flow(model);
    scene.measure.every = 1;
    auto const ladder = ladder_of(scene);
    ASSERT_GE(ladder.methods.size(), 3U);
    Snapshot const start = first_snapshot(random_start(scene).state);
    auto const usual = stepped(scene, start, {ladder.usual, ladder.usual}, 1 << 20);
    auto const first = static_cast<std::size_t>(ladder.grid / ladder.window);
    for (std::size_t method = 0; method < ladder.methods.size(); ++method) {
      auto const other = stepped(scene, start, {ladder.usual, method}, 1 << 20);
      ASSERT_EQ(other.windows.size(), usual.windows.size());
      for (auto w = first; w < first + 3; ++w)
        EXPECT_NEAR(pressure(other.windows[w]) / pressure(usual.windows[w]), 1, 0.01)
            << model << " " << method << " " << w;
      EXPECT_NEAR(other.last.state.offset, usual.last.state.offset, 1e-9);
      auto const& [scheme, length, parts] = ladder.methods[method];
      EXPECT_EQ(other.windows[first].weight * static_cast<double>(length),
                usual.windows[first].weight);
    }
  }
}

/// Quasi-static steps and back: the same bits however it is cut, and as where the engine is named.
TEST(AutoScheme, QuasiStaticSteps) {
  Scene scene = dense_flow("CD");
  scene.disks.count = 64;
  scene.shear.strain_rate = 1e-6;
  scene.integration.accuracy = 0.01;
  auto const ladder = ladder_of(scene);
  auto const method = ladder.methods[0];
  ASSERT_EQ(method.scheme, backward_euler);
  Snapshot const start = first_snapshot(random_start(scene).state);
  auto const whole = stepped(scene, start, {0, ladder.usual, 0}, 1 << 30);
  EXPECT_EQ(whole.last.counters.at("steps_by_quasi_static"), 2 * ladder.grid);
  auto const cut = stepped(scene, start, {0, ladder.usual, 0}, ladder.grid / 7, true);
  EXPECT_EQ(cut.last.state.position, whole.last.state.position);
  EXPECT_TRUE(same(cut.windows, whole.windows));

  auto const here = stepped(scene, start, {0}, 1 << 30);
  auto const named = make_simulation(with_method(scene, method), start, "serial");
  Sampling const sampling{.window_steps = ladder.window / method.length,
                          .every = 1,
                          .last_step = ladder.grid / method.length};
  OpenWindows windows;
  named->advance(sampling.last_step, sampling, windows);
  EXPECT_EQ(here.last.state.position, named->snapshot().state.position);
  EXPECT_TRUE(same(here.windows, windows.sums));
}

/// A checkpoint of a list with other methods.
TEST(AutoScheme, RefusesAnotherMethod) {
  Scene const scene = dense_flow("CD");
  Snapshot const start = first_snapshot(random_start(scene).state);
  auto snapshot = make_simulation(scene, start, "serial")->snapshot();
  EXPECT_NO_THROW(make_simulation(scene, snapshot, "serial"));
  auto longer = snapshot, finer = snapshot, beyond = snapshot;
  longer.memory.at("auto_length") *= 2;
  finer.memory.at("auto_parts") *= 2;
  beyond.memory.at("auto_method") = 100;
  for (auto const& other : {longer, finer, beyond})
    EXPECT_THROW(make_simulation(scene, other, "serial"), InputError);
  snapshot.memory.erase("auto_length");  // an older program's
  snapshot.memory.erase("auto_parts");
  EXPECT_NO_THROW(make_simulation(scene, snapshot, "serial"));
}

/// The usual method steps as if it were named, with events by turns in dilute flow.
TEST(AutoScheme, BeginsAsTwoStages) {
  Scene scene = dense_flow("CD_rot");
  scene.integration.engine = "many-contacts";
  auto const ladder = ladder_of(scene);
  Snapshot const start = first_snapshot(random_start(scene).state);
  auto const here = stepped(scene, start, {ladder.usual}, 1000);
  Sampling const sampling{
      .window_steps = ladder.window, .every = scene.measure.every, .last_step = ladder.grid};
  scene.integration.scheme = two_stage_scheme;
  OpenWindows windows;
  auto const plain = make_simulation(scene, start, "serial");
  plain->advance(ladder.grid, sampling, windows);
  EXPECT_EQ(here.last.state.position, plain->snapshot().state.position);
  EXPECT_TRUE(same(here.windows, windows.sums));

  Scene dilute = dense_flow("CD_n");
  dilute.disks.elasticity = 50;
  dilute.disks.packing_fraction = 0.3;
  dilute.shear.strain_rate = 1e-3;
  auto const by_turns = make_simulation(dilute, first_snapshot(shaken_start(dilute)), "serial");
  by_turns->advance(16384, {.window_steps = 512, .every = 10}, windows);
  EXPECT_GT(by_turns->snapshot().counters.at("steps_by_events"), 0);
}

}  // namespace bagnold::test
