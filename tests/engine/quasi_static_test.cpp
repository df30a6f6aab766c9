// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/config/errors.hpp"
#include "src/config/laws.hpp"
#include "src/config/skin.hpp"
#include "src/engine/device_copy.hpp"
#include "src/engine/quasi_static/quasi_static_engine.hpp"
#include "src/engine/wrap_state.hpp"
#include "src/measure/observables.hpp"
#include "tests/reference/backward_euler.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

Scene creeping_scene(std::string const& model, double packing_fraction, std::int64_t count) {
  Scene scene = small_scene(model, packing_fraction, count);
  scene.disks.elasticity = 1.0;
  scene.disks.mass = "equal";
  scene.shear.strain_rate = 1e-4;
  scene.integration.scheme = automatic;
  scene.integration.engine = quasi_static_engine;
  scene.integration.time_step = automatic;
  scene.integration.skin = 0.35;
  return scene;
}

/// Solves each step to a tolerance of the caller's.
template <bool rotates>
QuasiStaticEngine<rotates> solved_to(Scene const& scene, State const& state, Real tolerance) {
  auto const damping = law_of(scene.disks).constants(scene.disks);
  return {{species_of(state.diameter), make_species_table(scene.mass_by_area()), damping.normal,
           damping.tangential},
          scene.shear.strain_rate,
          time_step(scene),
          skin(scene),
          first_snapshot(state),
          tolerance};
}

/// Of a few dense disks that have flown for a while, contacts across all edges.
State flowing_start(Scene const& scene) {
  State state = shaken_start(scene);
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const k = static_cast<double>(i), rate = scene.shear.strain_rate;
    state.velocity[i] = {rate * (state.position[i][1] + 0.5 * std::sin(12.9898 * k)),
                         0.5 * rate * std::cos(78.233 * k)};
    if (!state.spin.empty()) state.spin[i] = rate * std::sin(4.1 * k);
  }
  return state;
}

/// Largest distance of disks of two states of one time.
double largest_spread(State a, State b) {
  for (auto* state : {&a, &b}) {
    for (auto& v : state->velocity) v = {0, 0};
    std::ranges::fill(state->spin, 0);
  }
  return largest_difference(a, b, 0);
}

class QuasiStatic : public testing::TestWithParam<std::string> {
 public:
  std::string law() const { return GetParam(); }

  /// The test's body for laws with and without spins.
  template <class Body>
  void with_engine(Scene const& scene, State const& state, Real tolerance, Body const& body) const {
    if (scene.rotates()) {
      auto engine = solved_to<true>(scene, state, tolerance);
      body(engine);
    } else {
      auto engine = solved_to<false>(scene, state, tolerance);
      body(engine);
    }
  }
};

}  // namespace

/// All pairs, all images, a dense matrix of differences: positions, motions and sums.
TEST_P(QuasiStatic, IsThatOfTheAllPairsReference) {
  for (auto const* mass : {"equal", "area"}) {
    Scene scene = creeping_scene(law(), 0.84, 16);
    scene.disks.mass = mass;
    State const state = flowing_start(scene);
    double const rate = scene.shear.strain_rate;
    auto p = reference_parameters(scene);
    ASSERT_DOUBLE_EQ(p.time_step, 10);
    reference::System oracle(p, state);
    with_engine(scene, state, 1e-11, [&](Simulation& simulation) {
      long contacts = 0;
      for (int k = 0; k < 12; ++k) {
        auto const expected = reference::backward_euler_step(oracle, 1e-10);
        auto const sums = advance(simulation, 1, 1).sums;
        EXPECT_LT(largest_difference(simulation.state(), oracle.s, rate), 1e-11) << k;
        using C = SumColumns;
        auto const near = [&](int column, double value, double scale) {
          EXPECT_NEAR(sums[column], value, 1e-5 * scale) << "column " << column << " step " << k;
        };
        double const stress = 16 * rate;
        near(C::elastic_xx, expected.elastic[0][0], stress);
        near(C::elastic_xy, expected.elastic[0][1], stress);
        near(C::elastic_yy, expected.elastic[1][1], stress);
        near(C::dissipative_xx, expected.dissipative[0][0], stress);
        near(C::dissipative_xy, expected.dissipative[0][1], stress);
        near(C::dissipative_yx, expected.dissipative[1][0], stress);
        near(C::dissipative_yy, expected.dissipative[1][1], stress);
        near(C::dissipation, expected.dissipation, stress * rate);
        if (scene.rotates()) near(C::torque_power, expected.torque_power, stress * rate);
        EXPECT_EQ(sums[C::contacts], 2.0 * static_cast<double>(expected.contacts));
        contacts += expected.contacts;
      }
      EXPECT_GT(contacts, 12 * 10);
    });
  }
}

/// The tolerance that is taken, against steps solved to rounding.
TEST_P(QuasiStatic, StopsIteratingWhereItMayDoSo) {
  Scene const scene = creeping_scene(law(), 0.84, 100);
  State const state = flowing_start(scene);
  auto const simulation = simulate(scene, state, "serial");
  auto const taken = advance(*simulation, 20, 1).sums;
  with_engine(scene, state, 1e-10, [&](Simulation& exact) {
    auto const sums = advance(exact, 20, 1).sums;
    EXPECT_GT(exact.snapshot().counters.at("newton_iterations"),
              simulation->snapshot().counters.at("newton_iterations"));
    for (int const c : {int{SumColumns::elastic_xx}, int{SumColumns::elastic_yy}})
      EXPECT_NEAR(taken[c] / sums[c], 1, 0.01);
  });
}

TEST_P(QuasiStatic, KeepsMomentum) {
  Scene const scene = creeping_scene(law(), 0.84, 100);
  State const state = flowing_start(scene);
  auto const simulation = simulate(scene, state, "serial");
  auto const momentum = [](Simulation const& of) {  // unwrapped, at the wrap of the list's build
    auto const snapshot = of.snapshot();
    std::array<double, 2> sum{};
    for (auto const& v : snapshot.state.velocity)
      for (int a = 0; a < 2; ++a) sum[a] += v[a];
    return sum;
  };
  auto const before = momentum(*simulation);
  auto const list = simulation->snapshot().list_step;
  advance(*simulation, 5);
  ASSERT_EQ(simulation->snapshot().list_step, list);
  for (int a = 0; a < 2; ++a)
    EXPECT_NEAR(momentum(*simulation)[a], before[a], 1e-14 * scene.shear.strain_rate * 100 * 10);
}

/// First order: towards the explicit trajectory half as far off with half the step.
TEST_P(QuasiStatic, MeetsTheExplicitTrajectoryInFirstOrder) {
  if (law() == "CD_nt") GTEST_SKIP() << "as CD_rot";
  Scene scene = creeping_scene(law(), 0.84, 64);
  scene.shear.strain_rate = 1e-3;
  Scene explicitly = scene;
  explicitly.integration.engine = "reference";
  explicitly.integration.scheme = two_stage_scheme;
  explicitly.integration.time_step = 0.01;
  auto const before = simulate(explicitly, flowing_start(scene), "serial");
  advance(*before, 100000);  // a strain of 1
  State const start = before->state();
  auto const straight = simulate(explicitly, start, "serial");
  advance(*straight, 2000);
  std::vector<double> off;
  for (int const steps : {40, 80, 160}) {
    scene.integration.time_step = 20.0 / steps;
    auto const simulation = simulate(scene, start, "serial");
    advance(*simulation, steps);
    off.push_back(largest_spread(simulation->state(), straight->state()));
  }
  EXPECT_LT(off[0], 1e-2);
  for (std::size_t k = 1; k < off.size(); ++k) {
    EXPECT_GT(off[k - 1] / off[k], 1.6) << off[k - 1] << " " << off[k];
    EXPECT_LT(off[k - 1] / off[k], 2.6) << off[k - 1] << " " << off[k];
  }
}

/// Nothing but the state and the list: in calls of any length, and from snapshots.
TEST_P(QuasiStatic, BitsDependOnNeitherCallsNorRestarts) {
  Scene const scene = creeping_scene(law(), 0.84, 100);
  State const state = flowing_start(scene);
  auto const straight = simulate(scene, state, "serial");
  auto const sums = advance(*straight, 60, 3);
  auto pieces = simulate(scene, state, "openmp");
  Sampling sampling;
  sampling.every = 3;
  sampling.last_step = 60;
  OpenWindows windows;
  for (int const steps : {1, 5, 17, 30, 100}) {
    pieces->advance(steps, sampling, windows);
    pieces = make_simulation(scene, pieces->snapshot(), "serial");
  }
  EXPECT_GT(straight->snapshot().list_builds, 1);
  EXPECT_EQ(pieces->step(), 60);
  EXPECT_EQ(pieces->state().position, straight->state().position);
  EXPECT_EQ(pieces->state().velocity, straight->state().velocity);
  EXPECT_EQ(pieces->state().spin, straight->state().spin);
  EXPECT_EQ(windows.take_first().sums, sums.sums);
  EXPECT_EQ(pieces->snapshot().counters, straight->snapshot().counters);
}

/// Disks that overlap by 100 times what they do in the flow: they fly apart within a step, in parts
/// of it and with lists of their own, and the flow goes on with the bits of an uncut one.
TEST_P(QuasiStatic, BearsAStartOfAFasterFlow) {
  Scene scene = creeping_scene(law(), 0.82, 100);
  scene.shear.strain_rate = 1e-3;
  scene.integration.engine = "reference";
  auto const fast = simulate(scene, flowing_start(scene), "serial");
  advance(*fast, 2000);
  State const start = fast->state();
  scene.shear.strain_rate = 1e-6;
  scene.integration.engine = quasi_static_engine;
  auto const flow = simulate(scene, start, "serial");
  advance(*flow, 4);
  EXPECT_GT(flow->snapshot().counters.at("halved_steps"), 0);
  EXPECT_GT(flow->snapshot().list_builds, 5);
  auto const again = make_simulation(scene, flow->snapshot(), "serial");
  advance(*flow, 10);
  advance(*again, 10);
  EXPECT_EQ(flow->state().position, again->state().position);
}

/// The same disks, further up and along, so that others lie across the edges.
TEST_P(QuasiStatic, DoesNotDependOnWhereTheEdgesAre) {
  Scene const scene = creeping_scene(law(), 0.84, 100);
  State const state = flowing_start(scene);
  double const rate = scene.shear.strain_rate, up = 0.4 * state.box_length;
  State moved = state;
  for (std::size_t i = 0; i < state.count(); ++i) {
    moved.position[i][0] += 0.3 * state.box_length;
    moved.position[i][1] += up;
    moved.velocity[i][0] += rate * up;
  }
  moved = [&] {
    State wrapped = moved;
    wrapped.strain_rate = rate;
    return wrap_state(wrapped);
  }();
  std::vector<State> after;
  for (auto const& start : {state, moved})
    with_engine(scene, start, 1e-11, [&](Simulation& simulation) {
      advance(simulation, 30);
      after.push_back(simulation.state());
    });
  State back = after[1];
  for (std::size_t i = 0; i < state.count(); ++i) {
    back.position[i][0] -= 0.3 * state.box_length + 0.03 * up;
    back.position[i][1] -= up;
    back.velocity[i][0] -= rate * up;
  }
  back.strain_rate = rate;
  EXPECT_LT(largest_difference(wrap_state(back), after[0], rate), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, QuasiStatic, testing::ValuesIn(law_names()),
                         [](auto const& info) { return info.param; });

namespace {

/// p, sigma and Z over a strain of 0.04, of a scene from a start.
std::array<double, 3> means(Scene const& scene, State const& start) {
  auto const simulation = simulate(scene, start, "serial");
  auto const steps = std::llround(0.04 / (scene.shear.strain_rate * time_step(scene)));
  auto sums = advance(*simulation, steps, std::max<std::int64_t>(1, steps / 100));
  for (auto& sum : sums.sums) sum /= sums.weight;
  std::array<double, 3> found{};
  for (auto const& o : observables(scene, start.box_length)) {
    if (o.name == "p") found[0] = o.value(sums.sums);
    if (o.name == "sigma") found[1] = o.value(sums.sums);
    if (o.name == "Z") found[2] = o.value(sums.sums);
  }
  return found;
}

}  // namespace

/// From common starts of a steady flow, against implicit damping: stresses are a percent low, Z is
/// a percent high (docs/accuracy.md).
TEST(QuasiStaticFlow, StressesAreThoseOfExplicitStepsWithinThreePercent) {
  for (auto const* model : {"CD", "CD_rot"}) {
    Scene scene = creeping_scene(model, 0.82, 256);
    scene.shear.strain_rate = 1e-5;
    Scene explicitly = scene;
    explicitly.integration.engine = "many-contacts";
    explicitly.integration.scheme = ImplicitDamping::name;
    auto const flow = simulate(scene, flowing_start(scene), "serial");
    advance(*flow, 1000);
    std::array<double, 3> euler{}, expected{};
    for (int k = 0; k < 4; ++k) {
      advance(*flow, 100);
      auto const start = flow->state();
      auto const a = means(scene, start), b = means(explicitly, start);
      for (std::size_t c = 0; c < 3; ++c) {
        euler[c] += a[c];
        expected[c] += b[c];
      }
    }
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(euler[c] / expected[c], 1, 0.03) << model << " " << c;
    EXPECT_LT(flow->snapshot().counters.at("halved_steps"), 20) << model;
  }
}

namespace {

std::string refused(Scene const& scene, std::string const& backend = "serial") {
  try {
    simulate(scene, shaken_start(small_scene("CD", 0.6, 16)), backend);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(QuasiStaticRefusals, NameWhatTheEngineCannotDo) {
  Scene const scene = creeping_scene("CD", 0.6, 16);
  EXPECT_EQ(refused(scene), "");
  auto const expect = [&](std::string const& part, auto const& change) {
    Scene changed = scene;
    change(changed);
    EXPECT_NE(refused(changed).find(part), std::string::npos) << refused(changed);
  };
  expect("integration.scheme = \"two-stage-leapfrog\"",
         [](Scene& s) { s.integration.scheme = two_stage_scheme; });
  expect("drive.kind = \"stokes\"", [](Scene& s) { s.drive.kind = "stokes"; });
  expect("here it is 2.5", [](Scene& s) { s.disks.force_exponent = 2.5; });
  expect("measure.contacts", [](Scene& s) { s.measure.contacts = true; });
  expect("measure.profiles", [](Scene& s) { s.measure.profiles = true; });
  expect("shear.protocol = \"ramp\"", [](Scene& s) { s.shear.protocol = "ramp"; });
  EXPECT_NE(refused(scene, "no-such").find("not in this build"), std::string::npos);
}

}  // namespace bagnold::test
