// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/contacts.hpp"

#include "tests/reference/binary_collision.hpp"
#include "tests/reference/energy.hpp"

namespace bagnold::test {

class Contacts : public EverySimulation {
 public:
  Scene small_scene(double packing_fraction = 0.82, std::int64_t count = 64) const {
    Scene scene = EverySimulation::small_scene(packing_fraction, count);
    scene.measure.contacts = true;
    return scene;
  }

  static void expect_same(std::vector<Happened> const& a, std::vector<Happened> const& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_EQ(a[k].key(), b[k].key()) << k;
      EXPECT_NEAR(std::remainder(a[k].theta - b[k].theta, 360), 0, 1e-4) << k;
    }
  }

  static void expect_same(OpenWindows const& a, OpenWindows const& b) {
    ASSERT_EQ(a.sums.size(), b.sums.size());
    for (std::size_t w = 0; w < a.sums.size(); ++w)
      for (std::size_t c = 0; c < a.sums[w].sums.size(); ++c)
        EXPECT_EQ(a.sums[w].sums[c], b.sums[w].sums[c]) << "window " << w << " column " << c;
  }
};

/// The velocities of every contact at the step that is its own, in any engine.
TEST_P(Contacts, AreLookedAtWhereAllPairsWouldBe) {
  constexpr std::pair<double, double> cases[] = {
      {0.82, 1.0}, {0.6, 1.0}, {0.82, 4.0}, {0.82, 0.25}};
  for (auto const& [packing_fraction, aspect] : cases) {
    Scene scene = small_scene(packing_fraction, 64);
    scene.disks.box_aspect = aspect;
    State const start = shaken_start(scene);
    Sampling const sampling{200, 7, 700};
    SampleChoice const choice(11);
    AllPairs const expected(scene, start, sampling, choice);
    ASSERT_GT(expected.samples.size(), 20u);
    auto simulation = simulate(scene, start, backend());
    Observed observed(*simulation, start.count(), 0, choice);
    auto const& record = observed.windows.contacts;
    while (simulation->step() < 700) {
      simulation->advance(83, sampling, observed.windows);
      auto const open = record->table.sorted();
      simulation = make_simulation(scene, simulation->snapshot(), backend());
      record->restore(open);
    }
    auto const& samples = observed.listener->samples;
    ASSERT_EQ(samples.size(), expected.samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
      ASSERT_EQ(samples[k].pair, expected.samples[k].pair) << k;
      ASSERT_EQ(samples[k].begin, expected.samples[k].begin) << k;
      auto const &a = samples[k].velocities, &b = expected.samples[k].velocities;
      EXPECT_NEAR(a.tangential, b.tangential, 1e-5) << k;
      EXPECT_NEAR(a.rotational, b.rotational, 1e-5) << k;
      EXPECT_NEAR(a.normal, b.normal, 1e-5) << k;
    }
  }
}

/// Every contact of every evaluated configuration once, with its velocities there, in any engine.
TEST_P(Contacts, AreOfferedOnceForEachEvaluatedConfiguration) {
  for (double packing_fraction : {0.82, 0.6}) {
    Scene const scene = small_scene(packing_fraction, 64);
    State const start = shaken_start(scene);
    Sampling const sampling{200, 7, 500};
    SampleChoice const choice(11);
    AllPairs const expected(scene, start, sampling, choice);
    ASSERT_GT(expected.picks.size(), packing_fraction > 0.7 ? 2000u : 100u);
    auto simulation = simulate(scene, start, backend());
    Observed observed(*simulation, start.count(), 0, choice);
    auto const& record = observed.windows.contacts;
    while (simulation->step() < 500) {
      simulation->advance(83, sampling, observed.windows);
      auto const open = record->table.sorted();
      simulation = make_simulation(scene, simulation->snapshot(), backend());
      record->restore(open);
    }
    auto const& picks = observed.listener->picks;
    ASSERT_EQ(picks.size(), expected.picks.size());
    for (auto a = picks.begin(), b = expected.picks.begin(); a != picks.end(); ++a, ++b) {
      ASSERT_EQ(a->first, b->first);
      EXPECT_NEAR(a->second.tangential, b->second.tangential, 1e-5);
      EXPECT_NEAR(a->second.rotational, b->second.rotational, 1e-5);
      EXPECT_NEAR(a->second.normal, b->second.normal, 1e-5);
    }

    Observed later(*simulate(scene, start, backend()), start.count(), 200, choice);
    later.listener->below = 0.5;
    auto const again = simulate(scene, start, backend());
    again->advance(500, sampling, later.windows);
    EXPECT_GT(later.listener->picks.size(), picks.size() / 5);
    EXPECT_LT(later.listener->picks.size(), picks.size() / 2);
    for (auto const& [rank, v] : later.listener->picks) {
      EXPECT_LT(rank, 0.5);
      EXPECT_TRUE(picks.contains(rank));
    }
  }
}

/// What rotation gains in all is what contacts exert on it, and a contact of tangential damping k_t
/// takes k_t v^C_T v^R of it in a unit of time: in a steady state <V^C_T V^R> = 0 over contacts in
/// time. With the velocities of every step, up to its square.
TEST_P(Contacts, VelocitiesAtTheContactTakeFromTheRotationWhatItLoses) {
  if (!small_scene().rotates()) GTEST_SKIP() << "has no rotation";
  Scene scene = small_scene(0.84, 64);
  State const start = shaken_start(scene);
  auto const energy = [&](State const& state) {
    return reference::rotation_energy(reference_parameters(scene), state);
  };
  auto const missed = [&](double time_step) {
    scene.integration.time_step = time_step;
    auto const simulation = simulate(scene, start, backend());
    Observed observed(*simulation, start.count());
    auto const steps = std::llround(20 / time_step);
    Sampling sampling{steps, 1, steps};
    simulation->advance(steps, sampling, observed.windows);
    auto const sum = [&](int column) {
      return observed.sum(0, ContactColumns::motion + column, simulation->columns());
    };
    double const k_t =
        (law() == "CD_nt" ? scene.disks.damping_tangential : 1.0) / scene.disks.elasticity;
    using M = ContactMotion;
    double const taken = time_step * k_t * (sum(M::tangential_rotational) + sum(M::rotational2));
    double const lost = energy(start) - energy(simulation->state());
    double const without_sign = time_step * k_t * sum(M::rotational2);
    return std::abs(taken - lost) / without_sign;
  };
  double const coarse = missed(0.02), fine = missed(0.01);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(fine, 0.6 * coarse);
}

/// Every begin and end, its angle, cluster and duration, and all sums.
TEST_P(Contacts, AreThoseOfAllPairsInEveryConfiguration) {
  for (double packing_fraction : {0.82, 0.6}) {
    Scene const scene = small_scene(packing_fraction, 64);
    State const start = shaken_start(scene);
    Sampling const sampling{200, 7, 700};
    AllPairs const expected(scene, start, sampling);
    ASSERT_GT(expected.all.size(), 100u);
    auto const simulation = simulate(scene, start, backend());
    Observed observed(*simulation, start.count());
    simulation->advance(700, sampling, observed.windows);
    expect_same(observed.listener->all, expected.all);
    ASSERT_EQ(observed.windows.sums.size(), expected.windows.size());
    for (std::size_t w = 0; w < expected.windows.size(); ++w)
      for (int c = 0; c < ContactColumns::count; ++c) {
        double const exact = expected.windows[w][static_cast<std::size_t>(c)];
        EXPECT_NEAR(observed.sum(w, c, simulation->columns()), exact, 1e-9 * std::abs(exact))
            << "window " << w << " column " << c;
      }
  }
}

/// Across the edges of blocks.
TEST_P(Contacts, OfManyDisksAreThoseOfTheReferenceEngine) {
  Scene scene = small_scene(0.8, 2500);
  State const start = shaken_start(scene);
  Sampling const sampling{100, 7, 150};
  auto const simulation = simulate(scene, start, backend());
  Observed observed(*simulation, start.count());
  simulation->advance(150, sampling, observed.windows);
  scene.integration.engine = "reference";
  auto const plain = simulate(scene, start, backend_names().front());
  Observed expected(*plain, start.count());
  plain->advance(150, sampling, expected.windows);
  EXPECT_GT(expected.listener->all.size(), 1000u);
  expect_same(observed.listener->all, expected.listener->all);
  for (std::size_t w = 0; w < 2; ++w)
    for (int c = 0; c < ContactColumns::count; ++c)
      EXPECT_NEAR(observed.sum(w, c, simulation->columns()), expected.sum(w, c, plain->columns()),
                  1e-7);
}

TEST_P(Contacts, DoNotDependOnHowARunIsCutAndActOnNothing) {
  for (double packing_fraction : {0.82, 0.6}) {
    Scene const scene = small_scene(packing_fraction, 300);
    State const start = shaken_start(scene);
    Sampling const sampling{200, 7, 700};
    auto const straight = simulate(scene, start, backend());
    auto chained = simulate(scene, start, backend());
    auto const unwatched = simulate(scene, start, backend());
    Observed a(*straight, start.count()), b(*chained, start.count());
    OpenWindows none;
    straight->advance(700, sampling, a.windows);
    unwatched->advance(700, sampling, none);
    while (chained->step() < 700) {
      chained->advance(83, sampling, b.windows);
      auto const open = b.windows.contacts->table.sorted();
      chained = make_simulation(scene, chained->snapshot(), backend());
      b.windows.contacts =
          std::make_shared<ContactRecord>(start.count(), chained->columns(), 0, b.listener);
      b.windows.contacts->table.restore(open);
    }
    expect_same(a.listener->all, b.listener->all);
    expect_same(a.windows, b.windows);
    EXPECT_EQ(straight->state().position, unwatched->state().position);
    EXPECT_EQ(straight->snapshot().memory, unwatched->snapshot().memory);
    EXPECT_EQ(straight->snapshot().counters, unwatched->snapshot().counters);
    for (std::size_t w = 0; w < none.sums.size(); ++w)
      for (std::size_t c = 0; c < none.sums[w].sums.size(); ++c)
        EXPECT_EQ(none.sums[w].sums[c], a.windows.sums[w].sums[c]);
  }
}

/// Durations add up to contacts: of all configurations, not only of those whose contacts ended.
TEST_P(Contacts, LastFromTheFirstConfigurationInContactToTheFirstOut) {
  Scene const scene = small_scene(0.8, 100);
  State const start = shaken_start(scene);
  Sampling const sampling{1000, 1, 1000};
  auto const simulation = simulate(scene, start, backend());
  Observed observed(*simulation, start.count());
  simulation->advance(1000, sampling, observed.windows);
  double inside = 0;  // of contacts that began and ended in the window
  for (auto const& e : observed.listener->all)
    if (!e.begins) inside += static_cast<double>(e.measure);
  EXPECT_EQ(observed.sum(0, ContactColumns::duration, simulation->columns()), inside);
  double at_ends = 0;  // of those that began before, or did not end
  for (auto const& c : observed.windows.contacts->table.sorted())
    at_ends += static_cast<double>(1000 - c.begin);
  auto const pair_steps = observed.windows.sums[0].sums[SumColumns::contacts] / 2;
  EXPECT_GE(pair_steps, inside + at_ends);
  EXPECT_EQ(observed.sum(0, ContactColumns::steps, simulation->columns()), 1000);
}

/// Head-on, in closed form: half a period of the damped oscillator, from 180 degrees to 0.
TEST_P(Contacts, OfTwoDisksLastAsLongAsTheClosedFormSays) {
  for (double elasticity : {2.0, 10.0, 50.0}) {
    Scene scene = small_scene();
    scene.disks.elasticity = elasticity;
    scene.disks.damping_normal = 1.0;
    scene.shear.strain_rate = 0.0;
    scene.integration.skin = 0.5;
    scene.integration.time_step = 0.01;
    double const expected =
        reference::BinaryCollision(reference_parameters(scene), 1.0, 1.0).duration();
    State state;
    state.box_length = 10.0;
    state.diameter = {1.0, 1.0};
    double const approach = 1e-3, gap = 0.3 * approach * 0.01 + 1e-6;
    state.position = {{4.0, 5.0}, {5.0 + gap, 5.0}};
    state.velocity = {{approach / 2, 0.0}, {-approach / 2, 0.0}};
    if (scene.rotates()) state.spin = {0.0, 0.0};
    auto const simulation = simulate(scene, state, backend());
    Observed observed(*simulation, 2);
    Sampling sampling;
    sampling.last_step = 1000;
    simulation->advance(1000, sampling, observed.windows);
    auto const& all = observed.listener->all;
    ASSERT_EQ(all.size(), 2u) << elasticity;
    EXPECT_EQ(all[0].measure, 2);
    EXPECT_NEAR(0.01 * static_cast<double>(all[1].measure), expected, 0.02);
    EXPECT_NEAR(std::abs(all[0].theta), 180, 1e-9);
    EXPECT_NEAR(all[1].theta, 0, 1e-9);
    EXPECT_EQ(observed.sum(0, ContactColumns::binary, simulation->columns()), 1);
  }
}

BAGNOLD_FOR_EVERY_SIMULATION(Contacts);

}  // namespace bagnold::test
