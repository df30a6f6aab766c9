// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/events.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "src/config/abilities.hpp"
#include "src/config/errors.hpp"
#include "src/config/laws.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/events.hpp"

namespace bagnold::test {
namespace {

class Events : public testing::TestWithParam<std::string> {
 public:
  std::string law() const { return GetParam(); }
};

}  // namespace

/// Plain steps converge to the events as their length goes to 0, to first order: the damping jumps
/// where contacts begin within a step.
TEST_P(Events, AreTheLimitOfStepsOfAllDisks) {
  Scene const scene = dilute_scene(law());
  State const start = flying_start(scene);
  auto const events = simulate_events(scene, start);
  double const time = 150;  // a strain of 0.015, before chaos
  advance(*events, std::llround(time / time_step(scene)));
  EXPECT_GT(events->snapshot().counters.at("collisions"), 30);
  std::vector<double> off;
  for (double const dt : {0.02, 0.01, 0.005}) {
    auto const plain = simulate_events(in_steps(scene, dt), start);
    advance(*plain, std::llround(time / dt));
    off.push_back(distance_between(events->state(), plain->state()));
  }
  EXPECT_LT(off[2], 2e-5);
  EXPECT_LT(off[2], 0.6 * off[0]);
}

TEST_P(Events, AreThoseOfTheAllPairsReference) {
  Scene const scene = dilute_scene(law(), 0.6, 16);
  State const start = flying_start(scene);
  auto const events = simulate_events(scene, start);
  reference::System oracle(reference_parameters(in_steps(scene, 0.005)), start);
  double const time = 200;
  advance(*events, std::llround(time / time_step(scene)));
  for (int k = 0; k < std::llround(time / 0.005); ++k) reference::step(oracle);
  EXPECT_GT(events->snapshot().counters.at("collisions"), 5);
  EXPECT_LT(distance_between(events->state(), oracle.s), 2e-5);
}

TEST_P(Events, KeepMomentumAndTheEnergyBalance) {
  for (double const packing_fraction : {0.7, 0.82}) {
    Scene scene = dilute_scene(law(), packing_fraction, 144);
    auto const events = simulate_events(scene, flying_start(scene));
    auto const masses = [&] {
      std::vector<double> m;
      for (double const d : events->state().diameter) m.push_back(disk_mass(true, d));
      return m;
    }();
    auto const momentum = [&](State const& state) {
      std::array<double, 2> sum{};
      for (std::size_t i = 0; i < state.count(); ++i) {
        sum[0] += masses[i] * (state.velocity[i][0] - slow_rate * state.position[i][1]);
        sum[1] += masses[i] * state.velocity[i][1];
      }
      return sum;
    };
    auto const before = events->state();
    auto const sums = advance(*events, 5000).sums;
    auto const after = events->state();
    EXPECT_NEAR(energy_gap(scene, before, sums, after), 0, 1e-4) << packing_fraction;
    auto const p = momentum(before), q = momentum(after);
    double const scale = 144 * 5 * slow_rate;
    // dv holds the y of the box: kinetic terms of the flow change the sum along x
    EXPECT_NEAR(q[1] - p[1], 0, 1e-11 * scale);
  }
}

/// Over whole contacts the trace of the dissipative virial is 0.
TEST_P(Events, HaveNoDissipativePressure) {
  Scene const scene = dilute_scene(law(), 0.7, 144);
  auto const events = simulate_events(scene, flying_start(scene));
  auto const sums = advance(*events, 5000).sums;
  using C = SumColumns;
  double const dissipative = sums[C::dissipative_xx] + sums[C::dissipative_yy];
  double const elastic = sums[C::elastic_xx] + sums[C::elastic_yy];
  EXPECT_LT(std::abs(dissipative), 2e-3 * elastic);
}

TEST_P(Events, BitsDoNotDependOnCutsWindowsOrRestarts) {
  for (double const packing_fraction : {0.6, 0.82}) {
    Scene const scene = dilute_scene(law(), packing_fraction, 100, 3);
    State const start = flying_start(scene);
    auto const straight = simulate_events(scene, start), silent = simulate_events(scene, start);
    auto chained = simulate_events(scene, start);
    Sampling const sampling{700, 1, 6000};
    OpenWindows a, b;
    straight->advance(6000, sampling, a);
    for (int k = 0; chained->step() < 6000; ++k) {
      chained->advance(1 + 97 * (k % 5), sampling, b);
      auto const here = chained->snapshot();
      chained = make_simulation(scene, here, "serial");
      EXPECT_EQ(chained->snapshot().arrays, here.arrays);
    }
    advance(*silent, 6000);
    for (auto const* other : {chained.get(), silent.get()}) {
      EXPECT_EQ(straight->state().position, other->state().position);
      EXPECT_EQ(straight->state().velocity, other->state().velocity);
      EXPECT_EQ(straight->state().spin, other->state().spin);
    }
    EXPECT_EQ(straight->snapshot().arrays, chained->snapshot().arrays);
    EXPECT_EQ(straight->snapshot().memory, chained->snapshot().memory);
    EXPECT_EQ(straight->snapshot().counters, chained->snapshot().counters);
    EXPECT_GT(straight->snapshot().list_builds, 1);
    EXPECT_GT(straight->snapshot().counters.at("busy_collisions"), packing_fraction > 0.8 ? 5 : 0);
    ASSERT_EQ(a.sums.size(), b.sums.size());
    for (std::size_t w = 0; w < a.sums.size(); ++w) {
      EXPECT_EQ(a.sums[w].sums, b.sums[w].sums) << w;
      EXPECT_EQ(a.sums[w].weight, b.sums[w].weight);
      EXPECT_EQ(a.sums[w].weight, w < 8 ? 700 : 400);
    }
  }
}

/// Sums of windows add up to those of one.
TEST_P(Events, SumsEndWithTheirWindows) {
  Scene const scene = dilute_scene(law(), 0.80, 100);
  State const start = flying_start(scene);
  auto const one = simulate_events(scene, start), many = simulate_events(scene, start);
  auto const whole = advance(*one, 3000).sums;
  OpenWindows windows;
  many->advance(3000, {30, 1, 3000}, windows);
  ASSERT_GE(windows.sums.size(), 100u);
  for (int c = 0; c < one->columns(); ++c) {
    double sum = 0, scale = 0;
    for (std::size_t w = 0; w < 100; ++w) {
      sum += windows.sums[w].sums[c];
      scale += std::abs(windows.sums[w].sums[c]);
    }
    EXPECT_NEAR(sum, whole[c], 1e-6 * scale) << c;
  }
  // means of a configuration each, of the same trajectory, are where the integrals are
  double sampled = 0;
  auto const probe = simulate_events(scene, start);
  for (int k = 0; k < 3000; ++k) {
    advance(*probe, 1);
    sampled += 2 * static_cast<double>(known_contacts(*probe, scene.rotates()).size());
  }
  EXPECT_NEAR(sampled / whole[SumColumns::contacts], 1, 0.02);
}

/// Contacts that begin at the same time: a lattice, all of whose disks meet.
TEST_P(Events, OfEqualTimes) {
  Scene scene = dilute_scene(law(), 0.5, 64);
  State start = flying_start(scene);
  std::size_t const side = 8;
  double const spacing = start.box_length / side;
  for (std::size_t i = 0; i < 64; ++i) {
    std::size_t const column = i % side, row = i / side;
    start.diameter[i] = 1;
    start.position[i] = {spacing * (0.5 + static_cast<double>(column)),
                         spacing * (0.5 + static_cast<double>(row))};
    double const towards = column % 2 == 0 ? 1 : -1, up = row % 2 == 0 ? 1 : -1;
    start.velocity[i] = {3 * slow_rate * towards, 3 * slow_rate * up};
  }
  start.offset = 0;
  auto const events = simulate_events(scene, start);
  auto const plain = simulate_events(in_steps(scene, 0.005), start);
  double const time = 1.2 * (spacing - 1) / (6 * slow_rate);
  advance(*events, std::llround(time / time_step(scene)));
  advance(*plain, std::llround(std::llround(time / time_step(scene)) * time_step(scene) / 0.005));
  EXPECT_GT(events->snapshot().counters.at("collisions"), 32);
  EXPECT_GT(events->snapshot().counters.at("busy_collisions"), 16);
  EXPECT_LT(distance_between(events->state(), plain->state()), 1e-5);
}

/// As a record has them of steps so short that they are the limit.
TEST_P(Events, ReportTheirContacts) {
  Scene scene = dilute_scene(law(), 0.7, 64);
  scene.measure.contacts = true;
  State const start = flying_start(scene);
  double const time = 150;
  struct Measured {
    std::vector<double> sums;
    std::vector<Happened> all;
    double dt;
    int columns;
  };
  auto const measure = [&](Scene const& of) {
    auto const simulation = simulate_events(of, start);
    auto const listener = std::make_shared<Listener>();
    double const dt = time_step(of);
    Sampling sampling;
    sampling.every = 1;
    sampling.last_step = std::llround(time / dt);
    OpenWindows windows;
    windows.contacts =
        std::make_shared<ContactRecord>(start.count(), simulation->columns(), 0, listener);
    while (simulation->step() < sampling.last_step) simulation->advance(50, sampling, windows);
    return Measured{windows.sums[0].sums, listener->all, dt, simulation->columns()};
  };
  auto const events = measure(scene), plain = measure(in_steps(scene, 0.01));
  auto const of = [](Measured const& m, int column) {
    return m.sums[static_cast<std::size_t>(m.columns + column)];
  };
  using K = ContactColumns;
  EXPECT_GT(of(events, K::ended), 20);
  for (int const c : {int{K::begun}, int{K::ended}, int{K::binary}})
    EXPECT_EQ(of(events, c), of(plain, c)) << c;
  double const duration = events.dt * of(events, K::duration) / of(events, K::ended);
  EXPECT_NEAR(duration / (plain.dt * of(plain, K::duration) / of(plain, K::ended)), 1, 0.01);
  for (int c = 0; c < ContactMotion::count; ++c) {
    double const expected = of(plain, c) * plain.dt;
    double const scale = c < 6 ? of(plain, 0) + of(plain, 1) + of(plain, 2)
                               : std::sqrt(of(plain, 9) * (of(plain, 0) + of(plain, 1)));
    EXPECT_NEAR(of(events, c) * events.dt, expected,
                2e-3 * (c == ContactMotion::contacts ? expected : scale * plain.dt))
        << c;
  }
  ASSERT_EQ(events.all.size(), plain.all.size());
  for (auto const& one : events.all) {
    auto const other = std::ranges::find_if(plain.all, [&](Happened const& h) {
      return h.begins == one.begins && h.pair == one.pair &&
             std::abs(static_cast<double>(h.step) * plain.dt -
                      static_cast<double>(one.step) * events.dt) < 0.4;
    });
    ASSERT_NE(other, plain.all.end()) << one.pair.first << " " << one.pair.second;
    double const turned = std::abs(std::remainder(other->theta - one.theta, 360));
    EXPECT_LT(turned, 3) << one.theta;
  }
}

TEST_P(Events, ContactsDoNotDependOnCutsOrRestarts) {
  Scene scene = dilute_scene(law(), 0.8, 100, 3);
  scene.measure.contacts = true;
  State const start = flying_start(scene);
  Sampling const sampling{300, 1, 1800};
  auto const record = [&](int columns) {
    return std::make_shared<ContactRecord>(start.count(), columns, 0, nullptr);
  };
  auto const straight = simulate_events(scene, start);
  auto chained = simulate_events(scene, start);
  OpenWindows a, b;
  a.contacts = record(straight->columns());
  b.contacts = record(straight->columns());
  straight->advance(1800, sampling, a);
  for (int k = 0; chained->step() < 1800; ++k) {
    chained->advance(1 + 97 * (k % 5), sampling, b);
    chained = make_simulation(scene, chained->snapshot(), "serial");
  }
  ASSERT_EQ(a.sums.size(), b.sums.size());
  for (std::size_t w = 0; w < a.sums.size(); ++w) EXPECT_EQ(a.sums[w].sums, b.sums[w].sums) << w;
  auto const one = a.contacts->table.sorted(), other = b.contacts->table.sorted();
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].a, other[k].a);
    EXPECT_EQ(one[k].begin, other[k].begin);
  }
  EXPECT_EQ(one.size(), known_contacts(*straight, scene.rotates()).size());
}

/// Velocities in contact, of all in each evaluated configuration and of each contact once: those of
/// steps of all disks, whose contacts differ by less than a step; and cuts change no bit.
TEST_P(Events, SampleVelocitiesInContact) {
  Scene scene = dilute_scene(law(), 0.78, 100, 5);
  scene.measure.contacts = scene.measure.correlations = true;
  State const start = flying_start(scene);
  SampleChoice const choice(3);
  double const time = 200, dt = 0.02;
  auto const measure = [&](Scene const& of, std::int64_t every, std::int64_t cut) {
    auto simulation = simulate_events(of, start);
    auto seen = std::make_unique<Observed>(*simulation, start.count(), 0, choice);
    Sampling sampling;
    sampling.every = every;
    sampling.last_step = std::llround(time / time_step(of));
    while (simulation->step() < sampling.last_step) {
      simulation->advance(cut, sampling, seen->windows);
      auto const open = seen->windows.contacts->table.sorted();
      simulation = make_simulation(of, simulation->snapshot(), "serial");
      seen->windows.contacts->restore(open);
    }
    return seen;
  };
  auto const events = measure(scene, 2, 1000), cut = measure(scene, 2, 13),
             plain = measure(in_steps(scene, dt), 20, 1000000);
  auto const squares = [](auto const& all, auto const& of) {
    std::array<double, 4> sum{};
    for (auto const& one : all) {
      ContactVelocities const& v = of(one);
      sum[0] += v.normal * v.normal;
      sum[1] += v.tangential * v.tangential;
      sum[2] += v.rotational * v.rotational;
      sum[3] += v.normal * v.tangential;
    }
    return sum;
  };
  auto const velocities_of_pick = [](auto const& one) { return one.second; };
  auto const &of_events = *events->listener, &of_plain = *plain->listener;
  ASSERT_GT(of_plain.picks.size(), 300u);
  EXPECT_NEAR(
      static_cast<double>(of_events.picks.size()) / static_cast<double>(of_plain.picks.size()), 1,
      0.01);
  auto const a = squares(of_events.picks, velocities_of_pick),
             b = squares(of_plain.picks, velocities_of_pick);
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 0.02 * (b[0] + b[1])) << c;
  auto const ended = std::ranges::count(of_events.all, false, &Happened::begins);
  EXPECT_EQ(of_events.samples.size(), static_cast<std::size_t>(ended));
  auto const one = squares(of_events.samples, [](auto const&s) { return s.velocities; }),
             other = squares(of_plain.samples, [](auto const&s) { return s.velocities; });
  EXPECT_NEAR((one[0] + one[1]) / (other[0] + other[1]), 1, 0.15);  // each at another moment of it
  ASSERT_EQ(cut->listener->picks.size(), of_events.picks.size());
  for (auto const& [rank, v] : of_events.picks)
    EXPECT_EQ(cut->listener->picks.at(rank).normal, v.normal);
  ASSERT_EQ(cut->listener->samples.size(), of_events.samples.size());
  for (std::size_t k = 0; k < of_events.samples.size(); ++k)
    EXPECT_EQ(cut->listener->samples[k].velocities.tangential,
              of_events.samples[k].velocities.tangential);
}

INSTANTIATE_TEST_SUITE_P(All, Events, testing::Values("CD", "CD_n", "CD_rot", "CD_nt"),
                         [](auto const& info) { return info.param; });

/// Two that pass each other while they touch: the line on which one leaves the contact passes its
/// place at the build of the lists by more than the reach, so that they are out of date at once.
TEST(EventsLists, AreBuiltOnceAStepAtMost) {
  Scene scene = dilute_scene("CD_n", 0.05, 4, 100);
  State start = shaken_start(scene);
  start.diameter = {1.0, 1.0, 1.4, 1.4};
  start.position = {{3, 3}, {7, 7}, {3, 4.1988}, {3.5, 7}};
  double const u = 0.2, v = 0.07;
  start.velocity = {{u, v}, {-u, 0}, {u, -v}, {-u, 0}};
  for (std::size_t i = 0; i < 4; ++i) start.velocity[i][0] += slow_rate * start.position[i][1];
  auto const events = simulate_events(scene, start);
  reference::System oracle(reference_parameters(in_steps(scene, 0.001)), start);
  double const time = 6;
  advance(*events, std::llround(time / time_step(scene)));
  EXPECT_GT(gap_of(events->state(), 0, 2), 0.1);  // parted
  for (int k = 0; k < std::llround(time / 0.001); ++k) reference::step(oracle);
  EXPECT_LT(distance_between(events->state(), oracle.s), 1e-4);
}

/// A contact that is nearly overdamped goes ahead: its amplitude is many times its overlap.
TEST(EventsOverlap, IsThatOfTheContact) {
  Scene scene = dilute_scene("CD_n", 0.05, 4, 1);
  scene.disks.mass = "equal";
  State start = shaken_start(scene);
  start.diameter = {1.0, 1.0, 1.4, 1.4};
  start.position = {{2, 2}, {5, 2}, {4, 6}, {4, 7.42}};
  start.velocity = {{0, 0}, {0, 0}, {0, 0.05}, {0, -0.05}};
  for (std::size_t i = 0; i < 4; ++i) start.velocity[i][0] += slow_rate * start.position[i][1];
  auto const events = simulate_events(scene, start);
  reference::System oracle(reference_parameters(in_steps(scene, 0.001)), start);
  double const time = 40;
  double deepest = 0;
  advance(*events, std::llround(time / time_step(scene)));
  for (int k = 0; k < std::llround(time / 0.001); ++k) {
    reference::step(oracle);
    deepest = std::max(deepest, -gap_of(oracle.s, 2, 3) / 1.4);
  }
  EXPECT_GT(deepest, 0.01);
  EXPECT_LT(deepest, 0.05);
  EXPECT_LT(distance_between(events->state(), oracle.s), 1e-4);
}

/// What fails is told at its step, with no pair that went on through each other beside it.
TEST(EventsOverlap, ThatIsTooDeepEndsTheRunThere) {
  Scene scene = dilute_scene("CD_n", 0.05, 4, 100);
  State start = shaken_start(scene);
  start.diameter = {1.0, 1.0, 1.4, 1.4};
  start.position = {{2, 2}, {6, 2.6}, {4, 6}, {4, 7.6}};
  start.velocity = {{0.03, 0}, {-0.03, 0}, {0, 0.4}, {0, -0.4}};
  for (std::size_t i = 0; i < 4; ++i) start.velocity[i][0] += slow_rate * start.position[i][1];
  auto const events = simulate_events(scene, start);
  try {
    advance(*events, 400);
    ADD_FAILURE();
  } catch (NumericalError const& error) {
    EXPECT_NE(std::string(error.what()).find("step 2 "), std::string::npos) << error.what();
  }
  EXPECT_EQ(events->step(), 2);
  EXPECT_GT(gap_of(events->state(), 0, 1), 0);
}

/// Pressure, temperature and contacts of a steady state are those of the default engine, within
/// four joint errors of ten blocks.
TEST(EventsSteadyState, IsThatOfTheDefaultEngine) {
  Scene scene = dilute_scene("CD_n", 0.6, 144, 50);
  State const start = flying_start(scene);
  using C = SumColumns;
  struct Mean {
    double mean, error;
  };
  auto const measure = [&](Scene const& of) {
    auto const simulation = simulate_events(of, start);
    auto const block = std::llround(1.0 / (slow_rate * time_step(of)));
    advance(*simulation, 2 * block);
    std::array<std::vector<double>, 4> blocks;
    for (int k = 0; k < 10; ++k) {
      auto const [sums, weight] = advance(*simulation, block, 10);
      double const elastic = sums[C::elastic_xx] + sums[C::elastic_yy];
      double const kinetic = sums[C::kinetic_xx] + sums[C::kinetic_yy];
      blocks[0].push_back((elastic + kinetic) / weight);
      blocks[1].push_back(kinetic / weight);
      blocks[2].push_back(-(sums[C::elastic_xy] + sums[C::dissipative_xy] + sums[C::kinetic_xy]) /
                          weight);
      blocks[3].push_back(sums[C::contacts] / weight);
    }
    std::array<Mean, 4> means{};
    for (std::size_t c = 0; c < 4; ++c) {
      double mean = 0, squares = 0;
      for (double const b : blocks[c]) mean += b / 10;
      for (double const b : blocks[c]) squares += (b - mean) * (b - mean);
      means[c] = {mean, std::sqrt(squares / 90)};
    }
    return means;
  };
  auto const events = measure(scene);
  scene.integration.engine = "auto";
  scene.integration.scheme = two_stage_scheme;
  auto const expected = measure(scene);
  for (std::size_t c = 0; c < 4; ++c) {
    double const error = std::hypot(events[c].error, expected[c].error);
    EXPECT_NEAR(events[c].mean, expected[c].mean, 4 * error) << c;
    EXPECT_LT(error, 0.08 * expected[c].mean) << c;
  }
}

TEST(EventsRefuse, WhatTheyCannotDo) {
  auto const refused = [](auto const& change) {
    Scene scene = dilute_scene("CD_n");
    change(scene);
    auto const list = why_not(scene);
    return list.size() == 1 ? list[0].message : std::to_string(list.size());
  };
  auto const has = [](std::string const& text, std::string const& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(refused([](Scene& s) { s.disks.force_exponent = 2.5; }), "harmonic repulsion alone");
  has(refused([](Scene& s) { s.disks.elasticity = 0.5; }), "overdamped");
  has(refused([](Scene& s) { s.drive.kind = "stokes"; }), "fly straight");
  has(refused([](Scene& s) { s.integration.scheme = papers_scheme; }), "exact-contacts");
  has(refused(
          [](Scene& s) { s.integration.engine = "auto", s.integration.scheme = exact_contacts; }),
      "engine = \"events\" alone");
  EXPECT_NEAR(least_underdamped_elasticity(dilute_scene("CD_n")), 0.588, 0.001);
}

}  // namespace bagnold::test
