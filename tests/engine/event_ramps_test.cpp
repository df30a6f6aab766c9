// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tests/support/contacts.hpp"
#include "tests/support/events.hpp"
#include "tests/support/ramps.hpp"

/// Strain rates that change while disks fly and touch.
namespace bagnold::test {
namespace {

class EventRamps : public testing::TestWithParam<std::string> {
 public:
  /// From 1e-4 to 4e-4 and back, by 6% a time unit, clusters where dense.
  static Scene ramp_scene(bool dense, std::int64_t count = 64) {
    Scene scene = dilute_scene(GetParam(), dense ? 0.82 : 0.65, count, dense ? 3.0 : 20.0);
    ramp_by_time_units(scene);
    return scene;
  }
};

/// Sums, each to a share of its scale: energies and stresses of its kind, or root mean squares.
/// Those of contacts differ by their begins and ends within steps. disk_time: disks times steps.
/// uncertain: of what is expected, 0 if empty.
void expect_same_sums(std::vector<double> const& sums, std::vector<double> const& expected,
                      double unit, double disk_time, double share,
                      std::vector<double> const& uncertain = {}) {
  using C = SumColumns;
  double const elastic = expected[C::elastic_xx] + expected[C::elastic_yy],
               kinetic = expected[C::kinetic_xx] + expected[C::kinetic_yy],
               speed2 = expected[C::velocity_x2] + expected[C::velocity_y2];
  for (int c = 0; c < static_cast<int>(sums.size()); ++c) {
    double scale = c < C::dissipation    ? elastic
                   : c < C::kinetic_xx   ? expected[C::dissipation]
                   : c < C::contacts     ? kinetic
                   : c == C::contacts    ? expected[C::contacts]
                   : c <= C::velocity_y2 ? speed2
                                         : 0;
    if (c == C::spin) scale = std::sqrt(expected[C::spin2] * disk_time);
    if (c == C::spin2) scale = expected[c];
    if (c == C::torque_power) scale = expected[C::dissipation];
    bool const of_contacts = c < C::kinetic_xx || c == C::contacts || c == C::torque_power;
    EXPECT_NEAR(sums[c] * unit, expected[c],
                (of_contacts ? 5 : 1) * share * scale + (uncertain.empty() ? 0 : uncertain[c]))
        << c;
  }
}

}  // namespace

/// Steps of all disks converge to the events, states and integrals over time. A contact that grazes
/// amplifies the error of steps: it is known from steps four times as long.
TEST_P(EventRamps, AreTheLimitOfStepsOfAllDisks) {
  for (bool const dense : {false, true}) {
    Scene const scene = ramp_scene(dense);
    State const start = flying_start(scene);
    auto const events = simulate_events(scene, start);
    auto const sums = advance_to(*events, make_ramp(scene).steps()).sums;
    auto const counters = events->snapshot().counters;
    EXPECT_GT(counters.at("carried_contacts"), 5);
    EXPECT_GT(counters.at("cluster_steps"), dense ? 200 : -1);
    State last;
    std::vector<double> last_sums;
    for (double const dt : {0.005, 0.00125}) {
      Scene const of_steps = in_steps(scene, dt);
      auto const plain = simulate_events(of_steps, start);
      auto expected = advance_to(*plain, make_ramp(of_steps).steps()).sums;
      EXPECT_NEAR(plain->state().time, events->state().time, 1e-9);
      EXPECT_EQ(plain->state().strain_rate, events->state().strain_rate);
      EXPECT_NEAR(plain->state().offset, events->state().offset, 1e-9);
      if (!last_sums.empty()) {
        double const off_of_steps = distance_between(plain->state(), last);
        EXPECT_LT(off_of_steps, dense ? 1e-3 : 1e-5);
        EXPECT_LT(distance_between(events->state(), plain->state()),
                  (dense ? 1e-5 : 2e-6) + 0.6 * off_of_steps);
        for (std::size_t c = 0; c < expected.size(); ++c)
          last_sums[c] = 0.6 * std::abs(4 * last_sums[c] - expected[c]);
        expect_same_sums(sums, expected, time_step(scene) / dt,
                         64.0 * static_cast<double>(plain->step()), 1e-3, last_sums);
      }
      last = plain->state();
      last_sums = std::move(expected);
    }
  }
}

/// Each piece of the ramp a run of its own at one rate. Steps of clusters, whose error is 1e-4 of
/// velocities, may differ.
TEST_P(EventRamps, AreThoseOfPiecesAtOneRate) {
  Scene scene = ramp_scene(true, 100);
  Ramp const ramp = make_ramp(scene);
  State state = flying_start(scene);
  auto const whole = simulate_events(scene, state);
  auto const sums = advance_to(*whole, ramp.steps());
  auto const expected =
      sums_of_pieces(scene, ramp, sums.sums.size(), state, simulate_events,
                     [](Simulation& one, std::int64_t steps) { return advance_to(one, steps); });
  EXPECT_LT(distance_between(whole->state(), state), 1e-6);
  EXPECT_EQ(sums.weight, expected.weight);
  expect_same_sums(sums.sums, expected.sums, 1, 100 * sums.weight, 1e-3);
}

TEST_P(EventRamps, BitsDoNotDependOnCutsOrRestarts) {
  for (bool const dense : {false, true}) {
    Scene scene = ramp_scene(dense, 100);
    scene.measure.contacts = true;
    scene.shear.cycles = 2;
    scene.shear.ramp_rate = 0.005;
    State const start = flying_start(scene);
    Ramp const ramp = make_ramp(scene);
    auto const straight = simulate_events(scene, start);
    auto chained = simulate_events(scene, start);
    Sampling const sampling{ramp.window_steps, 1, ramp.steps()};
    auto const record = [&](int columns) {
      return std::make_shared<ContactRecord>(start.count(), columns, 0, nullptr);
    };
    OpenWindows a, b;
    a.contacts = record(straight->columns());
    b.contacts = record(straight->columns());
    straight->advance(ramp.steps(), sampling, a);
    for (int k = 0; chained->step() < ramp.steps(); ++k) {
      chained->advance(1 + 43 * (k % 5), sampling, b);
      auto const here = chained->snapshot();
      chained = make_simulation(scene, here, "serial");
      EXPECT_EQ(chained->snapshot().arrays, here.arrays);
    }
    EXPECT_EQ(straight->state().position, chained->state().position);
    EXPECT_EQ(straight->state().velocity, chained->state().velocity);
    EXPECT_EQ(straight->state().spin, chained->state().spin);
    EXPECT_EQ(straight->snapshot().arrays, chained->snapshot().arrays);
    EXPECT_EQ(straight->snapshot().memory, chained->snapshot().memory);
    EXPECT_EQ(straight->snapshot().counters, chained->snapshot().counters);
    ASSERT_EQ(a.sums.size(), b.sums.size());
    for (std::size_t w = 0; w < a.sums.size(); ++w) {
      EXPECT_EQ(a.sums[w].sums, b.sums[w].sums) << w;
      EXPECT_EQ(a.sums[w].weight, b.sums[w].weight);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, EventRamps, testing::Values("CD", "CD_n", "CD_rot", "CD_nt"),
                         [](auto const& info) { return info.param; });

}  // namespace bagnold::test
