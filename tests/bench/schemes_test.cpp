// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <random>

#include "bench/accuracy/contact_radius.hpp"
#include "bench/accuracy/damped_contact.hpp"
#include "bench/accuracy/system.hpp"
#include "tests/reference/binary_collision.hpp"
#include "tests/reference/measure.hpp"

namespace bagnold::accuracy {
namespace {

/// A law and a scheme.
struct Case {
  std::string model, scheme;
};

Scene scene_of(std::string const& model, double elasticity, double rate) {
  Scene scene;
  scene.disks.model = model;
  scene.disks.mass = model == "CD_n" ? "area" : "equal";
  scene.disks.elasticity = elasticity;
  scene.shear.strain_rate = rate;
  return scene;
}

reference::Parameters parameters(Scene const& scene) {
  reference::Parameters p;
  p.model = scene.disks.model == "CD"     ? reference::Parameters::Model::CD
            : scene.disks.model == "CD_n" ? reference::Parameters::Model::CD_n
                                          : reference::Parameters::Model::CD_rot;
  p.area_mass = scene.mass_by_area();
  p.elasticity = scene.disks.elasticity;
  p.strain_rate = scene.shear.strain_rate;
  return p;
}

Method method(std::string const& scheme, double time_step) {
  Method m;
  m.scheme = scheme;
  m.time_step = time_step;
  return m;
}

/// A crowded box of disks that move and turn at random.
State crowd(bool rotates, std::size_t count = 200, unsigned seed = 3) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  State s;
  s.box_length = std::sqrt(1.1624 * static_cast<double>(count) / 0.9);
  for (std::size_t i = 0; i < count; ++i) {
    s.position.push_back({s.box_length * unit(random), s.box_length * unit(random)});
    s.velocity.push_back({0.01 * (unit(random) - 0.5), 0.01 * (unit(random) - 0.5)});
    s.diameter.push_back(i % 2 == 0 ? 1.0 : 1.4);
    if (rotates) s.spin.push_back(0.02 * (unit(random) - 0.5));
  }
  return s;
}

std::ostream& operator<<(std::ostream& to, Case const& c) {
  return to << c.model << " " << c.scheme;
}

class EveryScheme : public testing::TestWithParam<Case> {};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (auto const* model : {"CD", "CD_n", "CD_rot"})
    for (auto const& scheme : scheme_names()) all.push_back({model, scheme});
  return all;
}

std::string case_name(testing::TestParamInfo<Case> const& info) {
  std::string name = info.param.model + "_" + info.param.scheme;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Accuracy, EveryScheme, testing::ValuesIn(cases()), case_name);

/// Two disks in a contact that lasts, at a small speed: after half a tau_e the overlap is that of
/// the closed form, of which `distance` is left out; so the order shows.
double overlap_error(Case const& c, double time_step) {
  Scene const scene = scene_of(c.model, 1.0, 0.0);
  DampedContact const exact(scene);
  constexpr double speed = 1e-4, begin = 0.4, end = 0.9;
  auto const velocity = [&](double t) {
    return (exact.overlap(t + 1e-5) - exact.overlap(t - 1e-5)) / 2e-5;
  };
  State s;
  s.box_length = 10;
  s.diameter = {1, 1};
  s.position = {{4, 5}, {5 - speed * exact.overlap(begin), 5}};
  s.velocity = {{speed * velocity(begin) / 2, 0}, {-speed * velocity(begin) / 2, 0}};
  s.spin = {0, 0};
  auto const system = make_system(scene, s, method(c.scheme, time_step), true);
  for (long long k = 0; k < std::llround((end - begin) / time_step); ++k) system->step(nullptr);
  State const after = system->state();
  double const overlap = 1 - (after.position[1][0] - after.position[0][0]);
  return std::abs(overlap / speed - exact.overlap(end));
}

/// Lagged and Groot's damping is of first order, everything else of second.
TEST_P(EveryScheme, OrderInsideAContact) {
  double const ratio = overlap_error(GetParam(), 0.05) / overlap_error(GetParam(), 0.025);
  auto const& scheme = GetParam().scheme;
  bool const first = scheme == "lagged-velocity-verlet" || scheme == "groot-warren";
  EXPECT_NEAR(std::log2(ratio), first ? 1.0 : 2.0, 0.25) << ratio;
}

TEST(DampedContact, IsTheReferences) {
  for (double q : {0.1, 0.3, 1.0, 10.0, 500.0}) {
    Scene const scene = scene_of("CD_n", q, 0.0);
    DampedContact const here(scene);
    reference::BinaryCollision const there(parameters(scene), 1.0, 1.0);
    EXPECT_NEAR(here.restitution(), there.restitution(), 1e-14);
    EXPECT_NEAR(here.overlap(0.7), there.overlap(1.0, 0.7), 1e-14);
  }
}

/// Restitution e(Q), to first order in the step across the opening of the contact.
TEST_P(EveryScheme, RestitutionOfACollision) {
  for (double q : {2.0, 10.0}) {
    Scene const scene = scene_of(GetParam().model, q, 0.0);
    State s;
    s.box_length = 10;
    s.diameter = {1, 1.4};
    s.position = {{4, 5}, {5.2 + 1e-9, 5}};
    s.velocity = {{5e-5, 0}, {-5e-5, 0}};
    s.spin = {0, 0};
    reference::BinaryCollision const exact(parameters(scene), 1.0, 1.4);
    auto const system = make_system(scene, s, method(GetParam().scheme, 2e-3));
    for (int k = 0; k < std::llround(1.5 * exact.duration() / 2e-3); ++k) system->step(nullptr);
    State const after = system->state();
    EXPECT_NEAR((after.velocity[1][0] - after.velocity[0][0]) / 1e-4, exact.restitution(),
                4e-3 / q);
  }
}

/// Total momentum, to rounding; and for two disks orbital and spin angular momentum together.
TEST_P(EveryScheme, ConservesMomentum) {
  Scene const scene = scene_of(GetParam().model, 1.0, 0.0);
  auto const p = parameters(scene);
  State const before = crowd(scene.rotates());
  auto const system = make_system(scene, before, method(GetParam().scheme, 0.05));
  for (int k = 0; k < 200; ++k) system->step(nullptr);
  State const after = system->state();
  for (int axis : {0, 1}) {
    double change = 0, scale = 0;
    for (std::size_t i = 0; i < before.count(); ++i) {
      double const m = reference::mass(p, before.diameter[i]);
      change += m * (after.velocity[i][axis] - before.velocity[i][axis]);
      scale += m * std::abs(after.velocity[i][axis]);
    }
    EXPECT_LT(std::abs(change), 1e-13 * scale) << axis;
  }
}

double angular_momentum(Scene const& scene, State const& s) {
  auto const p = parameters(scene);
  double total = 0;
  for (std::size_t i = 0; i < s.count(); ++i) {
    double const m = reference::mass(p, s.diameter[i]);
    total += m * (s.position[i][0] * s.velocity[i][1] - s.position[i][1] * s.velocity[i][0]);
    if (!s.spin.empty()) total += reference::moment_of_inertia(p, s.diameter[i]) * s.spin[i];
  }
  return total;
}

/// Impulses act at r_n, and r_n+1 = r_n + v dt: exact with velocities half a step behind.
TEST_P(EveryScheme, ConservesAngularMomentumOfAPair) {
  auto const& [model, scheme] = GetParam();
  if (model == "CD") GTEST_SKIP() << "CD has no spins to take up the torque of its force";
  bool const exact = scheme != "modified-velocity-verlet";
  Scene const scene = scene_of(model, 1.0, 0.0);
  State s;
  s.box_length = 10;
  s.diameter = {1, 1.4};
  s.position = {{4, 5}, {5, 5.6}};
  s.velocity = {{0.02, 0.05}, {-0.03, 0.01}};
  if (scene.rotates()) s.spin = {0.3, -0.1};
  auto const system = make_system(scene, s, method(scheme, 0.05));
  double const before = angular_momentum(scene, s);
  for (int k = 0; k < 40; ++k) system->step(nullptr);
  EXPECT_NEAR(angular_momentum(scene, system->state()), before, exact ? 1e-14 : 1e-3);
}

/// A disk that touches nothing keeps its velocity to the bit.
TEST_P(EveryScheme, FreeDisksFlyStraight) {
  Scene const scene = scene_of(GetParam().model, 1.0, 0.0);
  State s;
  s.box_length = 10;
  s.diameter = {1, 1.4};
  s.position = {{2, 2}, {7, 7}};
  s.velocity = {{0.01, 0.02}, {-0.03, 0.01}};
  s.spin = {0.1, 0.2};
  auto const system = make_system(scene, s, method(GetParam().scheme, 0.25));
  for (int k = 0; k < 8; ++k) system->step(nullptr);
  State const after = system->state();
  for (int i : {0, 1})
    for (int axis : {0, 1}) {
      EXPECT_EQ(after.velocity[i][axis], s.velocity[i][axis]);
      EXPECT_NEAR(after.position[i][axis], s.position[i][axis] + 2 * s.velocity[i][axis], 1e-14);
    }
}

/// A sheared crowd after 1 tau_e: all schemes go to the same place as dt -> 0, that of the papers'.
TEST_P(EveryScheme, AgreesAsTheStepGoesToZero) {
  Scene const scene = scene_of(GetParam().model, 1.0, 0.01);
  State const start = crowd(scene.rotates(), 100, 7);
  auto const end = [&](std::string const& scheme, double dt) {
    auto const system = make_system(scene, start, method(scheme, dt), true);
    for (long long k = 0; k < std::llround(1 / dt); ++k) system->step(nullptr);
    return system->state();
  };
  auto const distance = [](State const& a, State const& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.count(); ++i) {
      double const x = std::abs(a.position[i][0] - b.position[i][0]);
      double const y = std::abs(a.position[i][1] - b.position[i][1]);
      if (x < 1 && y < 1) largest = std::max({largest, x, y});  // else through the edge
    }
    return largest;
  };
  State const exact = end("modified-velocity-verlet", 1.0 / 4096);
  double const coarse = distance(end(GetParam().scheme, 1.0 / 128), exact);
  double const fine = distance(end(GetParam().scheme, 1.0 / 1024), exact);
  EXPECT_LT(fine, 2e-4);
  EXPECT_LT(fine, 0.3 * coarse);
}

/// Blocks and packs change the order of pairs; two-stage does not feel it, to rounding.
TEST(TwoStage, DoesNotDependOnTheOrderOfPairs) {
  for (auto const* model : {"CD", "CD_n", "CD_rot"}) {
    Scene const scene = scene_of(model, 1.0, 1e-3);
    State const start = crowd(scene.rotates());
    Method plain = method("two-stage", 0.1), blocked = plain;
    blocked.arrangement = {.packs = true, .tiles = 3};
    auto const a = make_system(scene, start, plain), b = make_system(scene, start, blocked);
    for (int k = 0; k < 20; ++k) a->step(nullptr), b->step(nullptr);
    State const one = a->state(), other = b->state();
    for (std::size_t i = 0; i < one.count(); ++i)
      for (int axis : {0, 1})
        EXPECT_NEAR(one.velocity[i][axis], other.velocity[i][axis], 1e-12) << model;
  }
}

/// What a sample says is lost is what energy misses: work in - dissipation = change of energy,
/// closer as dt -> 0.
TEST_P(EveryScheme, SamplesCloseTheEnergyBalance) {
  Scene const scene = scene_of(GetParam().model, 1.0, 0.01);
  auto const gap = [&](double dt) {
    auto const system =
        make_system(scene, crowd(scene.rotates(), 100, 7), method(GetParam().scheme, dt), true);
    Sample first, last;
    double lost = 0, work = 0;
    auto const steps = std::llround(2 / dt);
    for (long long k = 0; k < steps; ++k) {
      Sample s;
      system->step(&s);
      if (k == 0) first = s;
      last = s;
      using C = SumColumns;
      lost += dt * s.value[Sample::dissipated];
      work -= dt * scene.shear.strain_rate *
              (s.value[C::elastic_xy] + s.value[C::dissipative_xy] + s.value[C::kinetic_xy]);
    }
    auto const energy = [](Sample const& s) {
      return s.value[Sample::kinetic_energy] + s.value[Sample::elastic_energy];
    };
    return std::abs(energy(last) - energy(first) - work + lost) / energy(first);
  };
  EXPECT_LT(gap(0.002), 0.01);
  EXPECT_LT(gap(0.002), 0.4 * gap(0.016));
}

/// The eigenvalues say when a contact grows: two disks in a contact without elastic force.
TEST_P(EveryScheme, GrowsWhereTheRadiusIsAboveOne) {
  auto const& [model, scheme] = GetParam();
  if (model == "CD_n") GTEST_SKIP() << "its contacts slide freely";
  Scene const scene = scene_of(model, 1.0, 0.0);
  int seen = 0;
  for (double dt : {0.05, 0.2, 0.3, 0.4, 0.6, 0.9, 1.1, 1.5, 2.0, 3.0, 5.0}) {
    double const radius = contact_radius(scene, scheme, dt).tangential;
    if (std::abs(radius - 1) < 0.02) continue;
    State s;
    s.box_length = 10;
    s.diameter = {1, 1};
    s.position = {{4, 5}, {4.999, 5}};
    s.velocity = {{0, 1e-12}, {0, -1e-12}};
    s.spin = {0, 0};
    Method m = method(scheme, dt);
    m.elastic = false;
    auto const system = make_system(scene, s, m);
    auto const sliding = [&] {
      State const now = system->state();
      double const turning = now.spin.empty() ? 0 : 0.4995 * (now.spin[0] + now.spin[1]);
      return std::abs(now.velocity[0][1] - now.velocity[1][1] + turning);
    };
    double const before = sliding();
    for (int k = 0; k < 60 && sliding() < 1e-7; ++k) {
      system->step(nullptr);
      system->place(s);
    }
    EXPECT_EQ(sliding() > before, radius > 1) << "dt = " << dt << " radius = " << radius;
    ++seen;
  }
  EXPECT_GT(seen, 5);
}

}  // namespace
}  // namespace bagnold::accuracy
