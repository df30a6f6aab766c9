// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/auto_scheme/auto_scheme.hpp"

#include "src/config/errors.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A flow of CD or CD_rot, dense and overdamped or dilute, at 1e-4.
Scene scene_of(std::string const& model, double packing_fraction) {
  Scene scene;
  scene.disks.model = model;
  scene.disks.count = 128;
  scene.disks.packing_fraction = packing_fraction;
  scene.disks.elasticity = 1.0;
  scene.shear.strain_rate = 1e-4;
  scene.integration.scheme = automatic;
  return scene;
}

std::int64_t stretch_of(Scene const& scene) {
  return implicit_step_length(scene) * std::max<std::int64_t>(160, 16 * scene.measure.every);
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

/// Steps on to `end` in calls of `piece` steps; `resumed`: through a snapshot after each.
Stepped stepped(Scene const& scene, Snapshot from, std::int64_t end, std::int64_t piece,
                bool resumed = false) {
  auto const length = implicit_step_length(scene);
  Sampling const sampling{
      .window_steps = 50 * length, .every = scene.measure.every, .last_step = end};
  OpenWindows windows;
  auto simulation = make_simulation(scene, std::move(from), "serial");
  while (simulation->step() < end) {
    simulation->advance(piece, sampling, windows);
    if (resumed) simulation = make_simulation(scene, simulation->snapshot(), "serial");
  }
  return {simulation->snapshot(), windows.sums};
}

double pressure(std::vector<WindowSums> const& windows, std::size_t from) {
  using C = SumColumns;
  double sum = 0, weight = 0;
  for (auto w = windows.begin() + static_cast<std::ptrdiff_t>(from); w != windows.end(); ++w) {
    for (int const c : {C::elastic_xx, C::elastic_yy, C::dissipative_xx, C::dissipative_yy})
      sum += w->sums[c];
    weight += w->weight;
  }
  return sum / weight;
}

}  // namespace

TEST(AutoScheme, TakesImplicitStepsWhereTheyServe) {
  Scene scene = scene_of("CD", 0.84);
  EXPECT_EQ(implicit_step_length(scene), 8);
  EXPECT_EQ(implicit_step_length(scene_of("CD_rot", 0.84)), 7);
  EXPECT_EQ(implicit_step_length(scene_of("CD_n", 0.84)), 1);
  Scene short_steps = scene_of("CD_n", 0.84);
  short_steps.integration.time_step = 0.01;
  EXPECT_EQ(implicit_step_length(short_steps), 1);
  EXPECT_EQ(resolved(scene).integration.scheme, automatic);
  auto const unsuited = [&](auto const& change) {
    Scene other = scene;
    change(other);
    EXPECT_EQ(implicit_step_length(other), 1);
    EXPECT_EQ(resolved(other).integration.scheme,
              other.integration.scheme == automatic ? two_stage_scheme : other.integration.scheme);
  };
  unsuited([](Scene& s) { s.integration.scheme = two_stage_scheme; });
  unsuited([](Scene& s) { s.integration.engine = "lookahead"; });
  unsuited([](Scene& s) { s.measure.contacts = true; });
  unsuited([](Scene& s) { s.shear.protocol = "ramp"; });
  unsuited([](Scene& s) { s.drive.kind = "stokes"; });
  unsuited([](Scene& s) { s.disks.elasticity = 200; });
  unsuited([](Scene& s) { s.integration.time_step = of_papers; });
  unsuited([](Scene& s) { s.integration.time_step = 1.0; });
}

/// A dense flow: same bits however it is cut, whichever thread and engine; means as of two stages.
TEST(AutoScheme, GoesOnBitForBit) {
  for (auto const* model : {"CD", "CD_rot"}) {
    Scene const scene = scene_of(model, 0.84);
    auto const stretch = stretch_of(scene);
    auto const end = 8 * stretch + 77;
    Snapshot const start = first_snapshot(random_start(scene).state);
    auto const whole = stepped(scene, start, end, end);
    EXPECT_GE(whole.last.counters.at("steps_by_implicit_damping"), 3 * stretch) << model;
    EXPECT_EQ(whole.last.step, end);
    for (auto const& [piece, resumed] :
         {std::pair{std::int64_t{100}, false}, {stretch / 3, true}}) {
      auto const cut = stepped(scene, start, end, piece, resumed);
      EXPECT_EQ(cut.last.state.position, whole.last.state.position) << model << resumed;
      EXPECT_EQ(cut.last.state.velocity, whole.last.state.velocity) << model << resumed;
      EXPECT_EQ(cut.last.memory, whole.last.memory) << model << resumed;
      EXPECT_TRUE(same(cut.windows, whole.windows)) << model << resumed;
    }
  }
}

TEST(AutoScheme, MeansAreThoseOfTwoStages) {
  Scene scene = scene_of("CD", 0.84);
  scene.measure.every = 1;  // the stress is growing, and a sample stands for what follows it
  auto const stretch = stretch_of(scene);
  Snapshot const start = first_snapshot(random_start(scene).state);
  auto const end = 2 * stretch;  // short: flows forget each other
  auto const here = stepped(scene, start, end, end);
  Scene two_stages = scene;
  two_stages.integration.scheme = two_stage_scheme;
  Sampling const sampling{.window_steps = 400, .every = 1, .last_step = end};
  OpenWindows windows;
  auto const plain = make_simulation(two_stages, start, "serial");
  plain->advance(end, sampling, windows);
  auto const first = static_cast<std::size_t>(stretch / 400) + 1;  // stepped alike
  EXPECT_NEAR(pressure(here.windows, first) / pressure(windows.sums, first), 1, 0.005);
  EXPECT_NEAR(here.last.state.offset, plain->snapshot().state.offset, 1e-9);
  double weight = 0, expected = 0;
  for (auto const& window : here.windows) weight += window.weight;
  for (auto const& window : windows.sums) expected += window.weight;
  EXPECT_NEAR(weight / expected, 1, 1e-12) << "each sample stands for its time";
}

/// In a dilute flow every trial fails, and what two stages then step has the bits of a run of them.
TEST(AutoScheme, RefusedStretchesLeaveNoTrace) {
  Scene scene = scene_of("CD_rot", 0.70);
  scene.integration.engine = "many-contacts";
  auto const end = 4 * stretch_of(scene) + 10;
  Snapshot const start = first_snapshot(shaken_start(scene));
  auto const here = stepped(scene, start, end, 1000);
  EXPECT_GE(here.last.counters.at("implicit_stretches_refused"), 2);
  EXPECT_EQ(here.last.counters.at("steps_by_implicit_damping"), 0);
  Sampling const sampling{
      .window_steps = 50 * implicit_step_length(scene), .every = 10, .last_step = end};
  scene.integration.scheme = two_stage_scheme;
  OpenWindows windows;
  auto const plain = make_simulation(scene, start, "serial");
  plain->advance(end, sampling, windows);
  EXPECT_EQ(here.last.state.position, plain->snapshot().state.position);
  EXPECT_TRUE(same(here.windows, windows.sums));
}

namespace {

/// An engine of nothing but a count: `fails` throws where it comes to that step.
struct Counting : Simulation {
  std::int64_t at, fails;
  std::map<std::string, double> counters;
  Counting(Snapshot&& s, std::int64_t f) : at(s.step), fails(f), counters(s.counters) {}
  int columns() const override { return SumColumns::count; }
  std::int64_t step() const override { return at; }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    for (auto const end = std::min(at + steps, sampling.last_step); at < end; ++at) {
      if (at == fails) throw NumericalError("too fast");
      std::vector<double> sums(SumColumns::count);
      sums[SumColumns::elastic_xx] = sums[SumColumns::contacts] = 1;
      if (sampling.sampled(at)) windows.add(sampling.window(at), sums, 1);
    }
  }
  Snapshot snapshot() const override {
    Snapshot s;
    s.step = at;
    s.counters = counters;
    return s;
  }
  State state() const override { return {}; }
};

}  // namespace

TEST(AutoScheme, AStretchThatFailsIsSteppedAgain) {
  Scene scene = scene_of("CD", 0.84);
  auto const length = implicit_step_length(scene), stretch = stretch_of(scene);
  auto const counting = [](std::int64_t fails_at) {
    return [=](Snapshot&& from) { return std::make_unique<Counting>(std::move(from), fails_at); };
  };
  AutoScheme simulation({.two_stages = counting(-1),
                         .implicit = counting((3 * stretch + 80) / length),
                         .length = length,
                         .every = scene.measure.every,
                         .strain_rate = scene.shear.strain_rate,
                         .time_step = time_step(scene)},
                        Snapshot{});
  Sampling const sampling{.window_steps = 40 * length, .every = 10, .last_step = 5 * stretch};
  OpenWindows windows;
  simulation.advance(5 * stretch, sampling, windows);
  EXPECT_EQ(simulation.step(), 5 * stretch);
  auto const counters = simulation.snapshot().counters;
  EXPECT_EQ(counters.at("implicit_stretches_refused"), 1);
  EXPECT_EQ(counters.at("steps_by_implicit_damping"), 3 * stretch);
  ASSERT_EQ(std::ssize(windows.sums), 5 * stretch / sampling.window_steps);
  for (auto const& window : windows.sums)
    EXPECT_EQ(window.weight, static_cast<double>(sampling.window_steps / 10));
}

}  // namespace bagnold::test
