// SPDX-License-Identifier: BSD-3-Clause
//
// Strain rates that change between steps, in every engine.
#include "src/config/ramp.hpp"

#include "kernels/physics/type_list.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/equal.hpp"
#include "tests/support/ramps.hpp"
#include "tests/support/scheduled_reference.hpp"
#include "tests/support/sums.hpp"

namespace bagnold::test {

class Ramps : public EverySimulation {
 public:
  /// A decade up and down, the rate changed by 6% every `piece` steps.
  Scene ramp_scene(double packing_fraction, std::string_view scheme, std::int64_t count = 64,
                   std::int64_t piece = 5) const {
    Scene scene = small_scene(packing_fraction, count);
    scene.start.kind = "state";  // no way by 1e-3
    scene.integration.scheme = scheme;
    scene.integration.skin = 0.35;
    auto& shear = scene.shear;
    shear.protocol = "ramp";
    shear.strain_rate = 2e-3;
    shear.strain_rate_high = 2e-2;
    shear.ramp_every = 0.05 * static_cast<double>(piece);
    shear.ramp_window = 50 * 0.05;
    shear.ramp_rate = 0.025 / shear.ramp_every * static_cast<double>(piece) / 5;
    shear.strain = 0.005;
    return scene;
  }

  /// As shaken_start(), slower.
  static State slow_start(Scene const& scene, double share = 0.2) {
    State state = shaken_start(scene);
    for (std::size_t i = 0; i < state.count(); ++i) {
      auto& v = state.velocity[i];
      double const flow = scene.shear.strain_rate * state.position[i][1];
      v = {flow + share * (v[0] - flow), share * v[1]};
    }
    return state;
  }

  static WindowSums advance_evaluating(Simulation& simulation, Ramp const& ramp,
                                       std::int64_t every) {
    return advance_to(simulation, ramp.steps(), every);
  }

  template <class Test>
  static void for_schemes(Test const& test) {
    for (auto const scheme : names_of<Schemes>()) {
      SCOPED_TRACE(scheme);
      test(scheme);
    }
  }
};

TEST_P(Ramps, AreThoseOfTheAllPairsReference) {
  if (backend() != backend_names().front()) GTEST_SKIP() << "see DoNotDependOnTheBackend";
  for_schemes([&](std::string_view scheme) {
    for (double const packing_fraction : {0.60, 0.84})
      for (double const aspect : {1.0, 4.0}) {
        bool const square = aspect == 1;
        if (!square && (packing_fraction < 0.8 || scheme != DefaultScheme::name)) continue;
        Scene scene = ramp_scene(packing_fraction, scheme, square ? 64 : 160);
        scene.disks.box_aspect = aspect;
        State const state = slow_start(scene);
        Ramp const ramp = make_ramp(scene);
        auto const simulation = simulate(scene, state, backend());
        ScheduledReference oracle(scene, state);
        for (std::int64_t const stop :
             {ramp.first_leg() + 3, ramp.first_leg() + ramp.leg_steps(), ramp.steps()}) {
          while (oracle.system().step < stop) oracle.step();
          advance(*simulation, stop - simulation->step());
          double const rate = oracle.system().p.strain_rate;
          EXPECT_EQ(simulation->state().strain_rate, rate);
          EXPECT_LT(largest_difference(simulation->state(), oracle.system().s, rate), 1e-11)
              << "phi " << packing_fraction << " aspect " << aspect << " step " << stop;
        }
        EXPECT_GE(simulation->snapshot().list_builds, 2);
        EXPECT_GE(reference::contacts(oracle.system()).size(), packing_fraction > 0.8 ? 50u : 1u);
      }
  });
}

/// The rate jumps by a thousand: lists of the slow flow would be outrun in a step.
TEST_P(Ramps, LoseNoContactInASuddenChange) {
  Scene scene = ramp_scene(0.8, DefaultScheme::name, 64, 200);
  auto& shear = scene.shear;
  shear.strain_rate = 2e-5;
  shear.ramp_window = shear.ramp_every;
  shear.ramp_rate = 3 / shear.ramp_every;
  shear.strain_rate_high = 20;  // two pieces
  shear.strain = 1e-5;
  State const state = random_start(scene).state;
  Ramp const ramp = make_ramp(scene);
  auto const simulation = simulate(scene, state, backend());
  ScheduledReference oracle(scene, state);
  auto const jump = ramp.first_leg() + ramp.piece_steps;
  for (auto const stop : {jump, jump + 20, jump + 200}) {
    while (oracle.system().step < stop) oracle.step();
    advance(*simulation, stop - simulation->step());
    double const rate = oracle.system().p.strain_rate;
    EXPECT_NEAR(rate, 2e-2, 1e-9);
    EXPECT_LT(largest_difference(simulation->state(), oracle.system().s, rate), 1e-9);
  }
}

/// Each piece of the ramp a simulation of its own at one rate.
TEST_P(Ramps, AreThoseOfPiecesAtOneRate) {
  for_schemes([&](std::string_view scheme) {
    Scene scene = ramp_scene(0.80, scheme, 100);
    Ramp const ramp = make_ramp(scene);
    auto const whole = simulate(scene, slow_start(scene), backend());
    auto const sums = advance_evaluating(*whole, ramp, 1);
    State state = slow_start(scene);
    auto const expected = sums_of_pieces(
        scene, ramp, sums.sums.size(), state,
        [&](Scene const& at, State const& from) { return simulate(at, from, backend()); },
        [](Simulation& one, std::int64_t steps) { return advance(one, steps, 1); });
    EXPECT_LT(largest_difference(whole->state(), state, scene.shear.strain_rate), 1e-10);
    EXPECT_NEAR(whole->state().time, state.time, 1e-10);
    EXPECT_EQ(sums.weight, expected.weight);
    for (std::size_t c = 0; c < expected.sums.size(); ++c)
      EXPECT_NEAR(sums.sums[c], expected.sums[c], 1e-9 * (1 + std::abs(expected.sums[c]))) << c;
  });
}

/// A dilute gas that is evaluated at every step, against the reference engine: flights and
/// collisions go on through changes of the rate, in lookaheads too.
TEST_P(Ramps, OfADiluteGas) {
  if (engine() == "reference") GTEST_SKIP() << "is the oracle";
  for_schemes([&](std::string_view scheme) {
    Scene scene = ramp_scene(0.6, scheme, 1200);
    scene.disks.elasticity = 10;
    scene.shear.strain_rate /= 20;
    scene.shear.strain_rate_high /= 20;
    scene.shear.strain = scene.shear.strain / 20;
    State state = slow_start(scene, 1);
    for (auto& v : state.velocity) v[1] -= 0.1;  // no common drift
    for (std::size_t i = 0; i < state.count(); ++i) {
      double const flow = scene.shear.strain_rate * state.position[i][1];
      state.velocity[i] = {flow + 0.3 * (state.velocity[i][0] - flow), 0.3 * state.velocity[i][1]};
    }
    Ramp const ramp = make_ramp(scene);
    auto const simulation = simulate(scene, state, backend());
    scene.integration.engine = "reference";
    auto const oracle = simulate(scene, state, backend_names().front());
    auto const sums = advance_evaluating(*simulation, ramp, 1);
    auto const expected = advance_evaluating(*oracle, ramp, 1);
    EXPECT_LT(largest_difference(simulation->state(), oracle->state(),
                                 oracle->state().strain_rate.value()),
              1e-10);
    using C = SumColumns;
    ASSERT_EQ(sums.weight, expected.weight);
    EXPECT_EQ(sums.weight, ramp.steps());
    EXPECT_GE(expected.sums[C::contacts], 2000.0);
    expect_equal_sums(sums, expected);
    if (engine() != "lookahead" || is_implicit(scheme)) return;
    auto const counters = simulation->snapshot().counters;
    EXPECT_GE(counters.at("lookahead_steps"), ramp.steps() / 2);
    EXPECT_GT(counters.at("lookahead_steps") / counters.at("lookaheads"), 2 * 5)
        << "beyond a piece";
    EXPECT_GT(counters.at("binary_islands"), 0);
    EXPECT_GT(counters.at("disks_in_larger_islands"), 0);
  });
}

/// Begins and ends of contacts, and their sums, are those of the reference engine, in collisions
/// and in thick flow; the run is interrupted now and then.
TEST_P(Ramps, HaveTheContactsOfTheReferenceEngine) {
  if (engine() == "reference") GTEST_SKIP() << "is the oracle";
  if (backend() != backend_names().front()) GTEST_SKIP() << "see DoNotDependOnTheBackend";
  for (double const packing_fraction : {0.6, 0.82}) {
    bool const thick = packing_fraction > 0.8;
    Scene scene = ramp_scene(packing_fraction, DefaultScheme::name, thick ? 300 : 1200);
    scene.disks.elasticity = thick ? 1 : 10;
    scene.measure.contacts = true;
    State const state = slow_start(scene, 0.3);
    Ramp const ramp = make_ramp(scene);
    Sampling const sampling{ramp.window_steps, 7, ramp.steps()};
    auto simulation = simulate(scene, state, backend());
    Observed seen(*simulation, state.count());
    while (simulation->step() < ramp.steps()) {
      simulation->advance(183, sampling, seen.windows);
      auto const open = seen.windows.contacts->table.sorted();
      simulation = make_simulation(scene, simulation->snapshot(), backend());
      seen.windows.contacts->restore(open);
    }
    scene.integration.engine = "reference";
    auto const oracle = simulate(scene, state, backend_names().front());
    Observed expected(*oracle, state.count());
    oracle->advance(ramp.steps(), sampling, expected.windows);
    auto const &a = seen.listener->all, &b = expected.listener->all;
    ASSERT_EQ(a.size(), b.size());
    EXPECT_GE(a.size(), 500u);
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_EQ(a[k].key(), b[k].key()) << k;
      EXPECT_NEAR(std::remainder(a[k].theta - b[k].theta, 360), 0, 1e-4) << k;
    }
    auto const &sums = seen.windows.sums, &sums_of_oracle = expected.windows.sums;
    ASSERT_EQ(sums.size(), sums_of_oracle.size());
    for (std::size_t w = 0; w < sums.size(); ++w)
      for (auto c = static_cast<std::size_t>(simulation->columns()); c < sums[w].sums.size(); ++c)
        EXPECT_NEAR(sums[w].sums[c], sums_of_oracle[w].sums[c],
                    1e-7 * (1 + std::abs(sums_of_oracle[w].sums[c])))
            << "window " << w << " column " << c;
  }
}

/// Interrupted and taken up again, where the rate changes and in between.
TEST_P(Ramps, GoOnFromASnapshot) {
  for_schemes([&](std::string_view scheme) {
    for (double const packing_fraction : {0.82, 0.55}) {
      Scene const scene = ramp_scene(packing_fraction, scheme, 300);
      Ramp const ramp = make_ramp(scene);
      State const state = slow_start(scene);
      Sampling const sampling{ramp.window_steps, 7, ramp.steps()};
      auto const straight = simulate(scene, state, backend());
      auto chained = simulate(scene, state, backend());
      OpenWindows a, b;
      straight->advance(ramp.steps(), sampling, a);
      for (int k = 0; chained->step() < ramp.steps(); ++k) {
        chained->advance(k % 3 == 0 ? 5 : 33, sampling, b);
        if (k % 2 == 0) chained->give_back_scratch();
        chained = make_simulation(scene, chained->snapshot(), backend());
      }
      expect_equal(straight->snapshot().state, chained->snapshot().state);
      EXPECT_EQ(straight->snapshot().list_position, chained->snapshot().list_position);
      EXPECT_EQ(straight->snapshot().list_builds, chained->snapshot().list_builds);
      EXPECT_EQ(straight->snapshot().memory, chained->snapshot().memory);
      EXPECT_EQ(straight->snapshot().counters, chained->snapshot().counters);
      ASSERT_EQ(a.sums.size(), b.sums.size());
      for (std::size_t w = 0; w < a.sums.size(); ++w) EXPECT_EQ(a.sums[w].sums, b.sums[w].sums);
    }
  });
}

TEST_P(Ramps, DoNotDependOnTheBackend) {
  for (double const packing_fraction : {0.82, 0.6}) {
    Scene const scene = ramp_scene(packing_fraction, DefaultScheme::name, 2500);
    State const state = slow_start(scene);
    auto const one = simulate(scene, state, backend());
    auto const first = simulate(scene, state, backend_names().front());
    auto const a = advance(*one, 120, 7), b = advance(*first, 120, 7);
    expect_equal(one->snapshot().state, first->snapshot().state);
    EXPECT_EQ(a.sums, b.sums);
  }
}

/// Lists live as long as they would at one rate: where it changes at every step, about as many are
/// built as where it changes in each fifty.
TEST_P(Ramps, KeepTheirLists) {
  auto const counts = [&](std::int64_t piece) {
    Scene const scene = ramp_scene(0.80, DefaultScheme::name, 300, piece);
    Ramp const ramp = make_ramp(scene);
    auto const simulation = simulate(scene, slow_start(scene), backend());
    advance(*simulation, ramp.steps());
    auto const snapshot = simulation->snapshot();
    auto const found = snapshot.counters.find("prunings");
    return std::pair{static_cast<double>(snapshot.list_builds),
                     found == snapshot.counters.end() ? 0 : found->second};
  };
  auto const [builds, prunings] = counts(1);
  auto const [builds_of_fifty, prunings_of_fifty] = counts(50);
  EXPECT_LE(builds, 1.25 * builds_of_fifty + 1);
  EXPECT_LE(prunings, 1.25 * prunings_of_fifty + 1);
  EXPECT_LT(builds, 40) << "of 400 pieces";
}

BAGNOLD_FOR_EVERY_SIMULATION(Ramps);

}  // namespace bagnold::test
