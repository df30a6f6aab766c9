// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/drives/drives.hpp"
#include "kernels/physics/random.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/engine/drive_columns.hpp"
#include "tests/reference/two_stage.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {

/// Forces on each disk alone, under every law, backend and scheme, in the engines that take them.
class Driven : public testing::TestWithParam<
                   std::tuple<std::string, std::string, std::string, std::string_view>> {
 public:
  std::string law() const { return std::get<0>(GetParam()); }
  std::string backend() const { return std::get<1>(GetParam()); }
  bool two_stages() const { return std::get<3>(GetParam()) == two_stage_scheme; }

  Scene scene(std::string_view kind, double packing_fraction, std::int64_t count = 64) const {
    Scene scene = small_scene(law(), packing_fraction, count);
    scene.integration.engine = std::get<2>(GetParam());
    scene.integration.scheme = std::get<3>(GetParam());
    scene.drive = {std::string(kind), 0.3, kind == ThermalBath::name ? 2e-3 : 0};
    return scene;
  }

  /// A gas that keeps what the bath gives it: contacts lose nothing.
  Scene lossless_gas(std::int64_t count) const {
    Scene gas = scene("thermal", 0.2, count);
    gas.disks.elasticity = 1e6;
    gas.drive.temperature = 2e-4;  // so hot that disks meet often, and no overlap nears 20%
    gas.shear.strain_rate = 1e-7;
    gas.integration.time_step = 0.1;
    gas.integration.skin = 0.5;
    return gas;
  }

  void step(reference::System& system) const {
    auto const scheme = std::get<3>(GetParam());
    double dissipative[2][2];
    if (scheme == two_stage_scheme)
      reference::two_stage_step(system, dissipative);
    else if (scheme == papers_scheme)
      reference::step(system);
    else
      throw reference::NoFormula("scheme", scheme);
  }

  static std::string name(testing::TestParamInfo<ParamType> const& info) {
    auto const& [law, backend, engine, scheme] = info.param;
    auto name = law + "_" + backend + "_" + engine + "_" + std::string(scheme);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};

INSTANTIATE_TEST_SUITE_P(All, Driven,
                         testing::Combine(testing::ValuesIn(law_names()),
                                          testing::ValuesIn(backend_names()),
                                          testing::Values("reference", "many-contacts"),
                                          testing::ValuesIn(explicit_schemes())),
                         Driven::name);

/// The push of a bath, from its formula: even, and so wide that s = f dt/m has the mean square
/// (T/m) (1 - R^2)/K^2 where a free disk does v -> R v + K s in a step.
std::array<double, 3> noise(reference::Parameters const& p, State const& state, bool two_stages,
                            double temperature, RandomStream const& stream, std::size_t disk,
                            long step) {
  double const d = state.diameter[disk];
  auto const width = [&](double drag, double mass) {
    double const z = drag * p.time_step / mass;
    double const share = two_stages ? reference::second_share(z) : 0.5;
    double const R = 1 - z + share * z * z, K = 1 - share * z;
    return std::sqrt(12 * temperature / mass * (1 - R * R)) / K * mass / p.time_step;
  };
  auto const random = stream.centred(disk, static_cast<std::uint64_t>(step));
  double const of_force = width(p.drag, reference::mass(p, d));
  double const of_torque = width(reference::spin_drag(p, d), reference::moment_of_inertia(p, d));
  return {of_force * random.x, of_force * random.y, of_torque * random.z};
}

/// Hundreds of steps, with list builds and crossings of the edges.
TEST_P(Driven, TrajectoryIsThatOfTheAllPairsReference) {
  for (auto const kind : names_of<Drives>())
    for (double const packing_fraction : {0.60, 0.84}) {
      Scene const scene = this->scene(kind, packing_fraction);
      State const state = shaken_start(scene);
      auto const simulation = simulate(scene, state, backend());
      auto p = reference_parameters(scene);
      p.drag = scene.drive.drag;
      RandomStream const stream(Stream::thermal_noise,
                                static_cast<std::uint64_t>(scene.disks.seed) ^ mixed(0));
      if (kind == ThermalBath::name)
        p.push = [&](std::size_t disk, long step) {
          return noise(p, state, two_stages(), scene.drive.temperature, stream, disk, step);
        };
      else if (kind != StokesDrag::name)
        throw reference::NoFormula("drive", kind);
      reference::System oracle(p, state);
      for (int k = 0; k < 300; ++k) step(oracle);
      advance(*simulation, 300);
      EXPECT_LT(largest_difference(simulation->state(), oracle.s, scene.shear.strain_rate), 1e-12)
          << kind << " " << packing_fraction;
      EXPECT_GE(simulation->snapshot().list_builds, 2);
    }
}

/// Two disks far apart: motion beyond the flow goes as e^-t with two stages, and with 1 - z + z^2/2
/// a step with the papers' scheme; a disk turns with the flow in the end.
TEST_P(Driven, AFreeDiskRelaxesToTheFlow) {
  Scene scene = this->scene("stokes", 0.1);
  State state;
  state.box_length = 20;
  state.position = {{5.0, 4.0}, {15.0, 14.0}};
  double const rate = scene.shear.strain_rate;
  state.velocity = {{rate * 4.0, 1e-3}, {rate * 14.0, -2e-3}};
  state.diameter = {1.0, 1.4};
  if (scene.rotates()) state.spin = {0.1, -0.2};
  scene.integration.time_step = 0.5;
  auto const p = reference_parameters(scene);
  auto const remains = [&](double z, int steps) {
    return two_stages() ? std::exp(-z * steps) : std::pow(1 - z + z * z / 2, steps);
  };
  auto const simulation = simulate(scene, state, backend());
  constexpr int steps = 20;
  advance(*simulation, steps);
  State const after = simulation->state();
  for (std::size_t i : {0, 1}) {
    double const d = state.diameter[i], zeta = scene.drive.drag, dt = 0.5;
    EXPECT_NEAR(after.velocity[i][1],
                state.velocity[i][1] * remains(zeta * dt / reference::mass(p, d), steps), 1e-16);
    if (!scene.rotates()) continue;
    double const z = zeta * d * d / 3 * dt / reference::moment_of_inertia(p, d);
    EXPECT_NEAR(after.spin[i] + rate / 2, (state.spin[i] + rate / 2) * remains(z, steps), 1e-15);
  }
}

/// m <v_x^2> = m <v_y^2> = I <thetadot^2> = T for disks of both sizes; errors of the four means are
/// 0.5% to 0.7%.
TEST_P(Driven, ABathSharesItsTemperatureEvenly) {
  Scene const gas = lossless_gas(200);
  State const start = random_start(gas).state;
  auto const simulation = simulate(gas, start, backend());
  auto const p = reference_parameters(gas);
  advance(*simulation, 400);
  struct Mean {
    double sum = 0, count = 0;
    void add(double value) { sum += value, ++count; }
    double relative(double temperature) const { return sum / count / temperature; }
  };
  Mean x[2], y[2], spin[2];
  for (int k = 0; k < 300; ++k) {
    advance(*simulation, 50);
    State const s = simulation->state();
    for (std::size_t i = 0; i < s.count(); ++i) {
      int const size = s.diameter[i] > 1.2;
      double const m = reference::mass(p, s.diameter[i]);
      x[size].add(m * s.velocity[i][0] * s.velocity[i][0]);
      y[size].add(m * s.velocity[i][1] * s.velocity[i][1]);
      if (gas.rotates())
        spin[size].add(reference::moment_of_inertia(p, s.diameter[i]) * s.spin[i] * s.spin[i]);
    }
  }
  double const T = gas.drive.temperature;
  for (int size : {0, 1}) {
    EXPECT_NEAR(x[size].relative(T), 1, 0.04) << size;
    EXPECT_NEAR(y[size].relative(T), 1, 0.04) << size;
    if (gas.rotates()) {
      EXPECT_NEAR(spin[size].relative(T), 1, 0.04) << size;
    }
  }
}

/// Of two stages, at the velocities halfway through the step, which the drag's second stage changes
/// too: so strong a drag that the sums without it would be off by a thousandth.
TEST_P(Driven, DissipationIsThatOfTheAllPairsReference) {
  if (!two_stages()) GTEST_SKIP() << "is of the configuration";
  Scene scene = this->scene("stokes", 0.84);
  scene.drive.drag = 3;
  State const state = shaken_start(scene);
  auto const simulation = simulate(scene, state, backend());
  auto p = reference_parameters(scene);
  p.drag = scene.drive.drag;
  reference::System oracle(p, state);
  for (int k = 0; k < 20; ++k) {
    double dissipative[2][2];
    auto const power = reference::two_stage_step(oracle, dissipative);
    auto const sums = advance(*simulation, 1, 1).sums;
    EXPECT_NEAR(sums[SumColumns::dissipation], power.dissipation, 1e-11 * power.dissipation) << k;
    EXPECT_NEAR(sums[SumColumns::dissipative_xy], dissipative[0][1],
                1e-11 * (1 + std::abs(dissipative[0][1])));
  }
}

/// Without contacts and shear what the drive gives and takes is what the motion gains, to rounding.
TEST_P(Driven, PowersAreWhatTheMotionGains) {
  for (std::string const kind : {"stokes", "thermal"}) {
    Scene scene = this->scene(kind, 0.05);
    scene.shear.strain_rate = 0;
    scene.integration.time_step = 0.05;
    State state = random_start(scene).state;
    for (std::size_t i = 0; i < state.count(); ++i) {
      double const apart = state.box_length / 8;
      state.position[i] = {apart * static_cast<double>(i % 8), apart * static_cast<double>(i / 8)};
      state.velocity[i] = {0.02 * std::sin(12.9898 * static_cast<double>(i)),
                           0.02 * std::cos(78.233 * static_cast<double>(i))};
      if (scene.rotates()) state.spin[i] = 0.02 * std::sin(4.1 * static_cast<double>(i));
    }
    auto const p = reference_parameters(scene);
    auto const simulation = simulate(scene, state, backend());
    auto const energy = [&] {
      return reference::measure(reference::System(p, simulation->state())).kinetic_energy;
    };
    auto const drive = static_cast<std::size_t>(engine_columns(scene.rotates(), false));
    for (int k = 0; k < 20; ++k) {
      double const before = energy();
      auto const sums = advance(*simulation, 1, 1).sums;
      double const gained = (energy() - before) / scene.integration.time_step.number.value();
      double const drag = sums.at(drive + DriveColumns::drag);
      double const push = sums.at(drive + DriveColumns::push);
      ASSERT_EQ(sums[SumColumns::contacts], 0);
      EXPECT_NEAR(push - drag, gained, 1e-11 * (std::abs(push) + drag));
      EXPECT_GT(drag, 0);
      if (kind == "stokes") {
        EXPECT_EQ(push, 0);
      }
    }
  }
}

/// With contacts and shear: d(K + V)/dt = sigma gammadot L_x L_y - dissipation - drag + push.
TEST_P(Driven, EnergyIsAccountedFor) {
  Scene scene = this->scene("thermal", 0.82, 100);
  scene.integration.time_step = 0.02;
  State const state = shaken_start(scene);
  auto const p = reference_parameters(scene);
  auto const simulation = simulate(scene, state, backend());
  auto const energy = [&] {
    auto const sums = reference::measure(reference::System(p, simulation->state()));
    return sums.kinetic_energy + sums.elastic_energy;
  };
  double const before = energy();
  auto const sums = advance(*simulation, 1500, 1).sums;
  using C = SumColumns;
  auto const drive = static_cast<std::size_t>(engine_columns(scene.rotates(), false));
  double const shear = -(sums[C::elastic_xy] + sums[C::dissipative_xy] + sums[C::kinetic_xy]) *
                       scene.shear.strain_rate;
  double const drag = sums[drive + DriveColumns::drag], push = sums[drive + DriveColumns::push];
  double const power = shear - sums[C::dissipation] - drag + push;
  EXPECT_GT(push, 0);
  EXPECT_NEAR(energy() - before, 0.02 * power, 0.02 * 0.02 * (std::abs(shear) + drag + push));
}

/// How a run is cut, and whether it is taken up again from a snapshot, changes no bit; another
/// seed, or a run that goes on from the state of another, has other noise.
TEST_P(Driven, NoiseIsOfTheDiskAndTheStep) {
  Scene scene = this->scene("thermal", 0.82, 300);
  State const state = shaken_start(scene);
  auto const straight = simulate(scene, state, backend());
  auto const expected = advance(*straight, 200, 7);
  auto const first = simulate(scene, state, backend());
  auto const begun = advance(*first, 90, 7);
  auto const rest = make_simulation(scene, first->snapshot(), backend());
  advance(*rest, 110, 7);
  EXPECT_EQ(rest->state().velocity, straight->state().velocity);
  EXPECT_EQ(rest->state().spin, straight->state().spin);
  auto const on_first = simulate(scene, state, backend_names().front());
  EXPECT_EQ(advance(*on_first, 200, 7).sums, expected.sums);

  scene.disks.seed = 2;
  auto const seeded = simulate(scene, state, backend());
  advance(*seeded, 200);
  EXPECT_GT(largest_difference(seeded->state(), straight->state(), scene.shear.strain_rate), 1e-3);
  scene.disks.seed = 1;
  State later = state;
  later.time = 17;
  auto const gone_on = simulate(scene, later, backend());
  advance(*gone_on, 200);
  EXPECT_GT(largest_difference(gone_on->state(), straight->state(), scene.shear.strain_rate), 1e-3);
}

/// A gas that flows with sigma ~ gammadot^2 is Newtonian in a fluid, P2 Sec. IV: at rates of which
/// one is a fourth of the other sigma/gammadot agrees; without drag it is three to four times as
/// large at the larger one.
TEST(Drive, FlowInAFluidIsNewtonianAtSmallRates) {
  auto const viscosity = [](double drag, double rate) {
    Scene scene = small_scene("CD_n", 0.70, 200);
    scene.disks.elasticity = 2;
    scene.disks.mass = "equal";
    scene.shear.strain_rate = rate;
    scene.integration = {};
    if (drag > 0) scene.drive = {"stokes", drag, 0};
    State start = random_start(scene).state;
    auto const simulation = simulate(scene, start, backend_names().front());
    auto const steps = static_cast<std::int64_t>(4 / (rate * time_step(scene)));
    advance(*simulation, steps / 2);
    auto const sums = advance(*simulation, steps, 10);
    using C = SumColumns;
    return -(sums.sums[C::elastic_xy] + sums.sums[C::dissipative_xy] + sums.sums[C::kinetic_xy]) /
           (sums.weight * rate);
  };
  EXPECT_NEAR(viscosity(0.5, 1e-3) / viscosity(0.5, 2.5e-4), 1, 0.15);
  EXPECT_GT(viscosity(0, 1e-3) / viscosity(0, 2.5e-4), 2.5);
}

}  // namespace bagnold::test
