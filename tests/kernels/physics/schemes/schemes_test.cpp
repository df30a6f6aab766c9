// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/schemes/schemes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/type_list.hpp"
#include "tests/support/schemes.hpp"

namespace bagnold::test {
namespace {

using Papers = ModifiedVelocityVerlet;
using TwoStage = TwoStageLeapfrog;
using simd::Pack;

/// r = 1, v = 2, dt = 1/4, dt/m = 1/2; forces 3, then -1: all exact.
template <class T>
void expect_numbers_by_hand() {
  auto const is = [](T const& value, double expected) {
    if constexpr (std::is_same_v<T, Pack>)
      for (int k = 0; k < simd::width; ++k) EXPECT_EQ(value.v[k], expected);
    else
      EXPECT_EQ(value, expected);
  };
  T const r = 1.0, v = 2.0, first = 3.0, second = -1.0, dt = 0.25, per_mass = 0.5;
  T const trial = Papers::trial_velocity(v, first, per_mass);
  is(trial, 3.5);                             // 2 + 3/2
  is(Papers::trial_position(r, v, dt), 1.5);  // 1 + 2/4
  T const after = Papers::velocity(v, trial, second, T(0.5) * per_mass);
  is(after, 2.5);                                          // (2 + 3.5)/2 - 1/4
  is(Papers::position(r, v, after, T(0.5) * dt), 1.5625);  // 1 + (2 + 2.5)/8

  T const change = TwoStage::change(first, per_mass);
  is(change, 1.5);
  T const leapt = TwoStage::velocity(v, change, second, per_mass);
  is(leapt, 3.0);  // 2 + 1.5 - 1/2
  is(TwoStage::velocity_of_pair(v, first + second, per_mass), 3.0);
  is(TwoStage::position(r, leapt, dt), 1.75);  // 1 + 3/4

  Vec2<T> const place = flown(Vec2<T>{r, v}, Vec2<T>{second, first}, dt);
  is(place.x, 0.75);
  is(place.y, 2.75);
}

TEST(Schemes, NumbersByHand) { expect_numbers_by_hand<Real>(); }
TEST(Schemes, NumbersByHandInPacks) { expect_numbers_by_hand<Pack>(); }

/// Bits of a trajectory hang on it: plain numbers are rounded after the product and after the sum.
TEST(MultiplyAdd, RoundsPlainNumbersTwice) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  int differ = 0;
  for (int k = 0; k < 1000; ++k) {
    double const a = normal(random), b = normal(random), c = normal(random);
    double const volatile product = a * b;
    EXPECT_EQ(multiply_add(a, b, c), product + c);
    differ += multiply_add(a, b, c) != std::fma(a, b, c);
  }
  EXPECT_GT(differ, 100);
}

TEST(TwoStageLeapfrog, ShareIsTheSeriesWhereTheDifferenceCancels) {
  for (double z = 1e-6; z < 0.3; z *= 1.1) {
    double sum = 0, term = 0.5;  // sum of (-z)^k / (k + 2)!
    for (int k = 0; k < 20; ++k, term *= -z / (k + 2)) sum += term;
    EXPECT_NEAR(TwoStage::share(z), sum, z < 1e-3 ? 1e-11 : 1e-9) << z;
  }
  EXPECT_DOUBLE_EQ(TwoStage::share(1), std::exp(-1.0));
  EXPECT_EQ(TwoStage::share(1e3), 1.0 / 7);
}

constexpr LoneContact sliding(Real rate) { return {0, rate}; }
constexpr LoneContact undamped(Real stiffness) { return {stiffness, 0}; }

template <class S>
double factor(S scheme, double rate) {
  return ContactMatrix::of(scheme, sliding(rate), 1).vv;
}

/// Damping alone, y = c dt: 1 - y + y^2/2, and 1 - y + alpha y^2, which for a lone pair is e^-y.
TEST(ContactMatrix, OfDampingByHand) {
  for (double const y : {0.1, 0.7, 1.0, 1.9, 2.0, 2.1}) {
    EXPECT_NEAR(factor(Papers{}, y), 1 - y + y * y / 2, 1e-15) << y;
    EXPECT_NEAR(factor(TwoStage{}, y), std::exp(-y), 1e-15) << y;
  }
  EXPECT_NEAR(factor(TwoStage{}, 6.9), 1 - 6.9 + 6.9 * 6.9 / 7, 1e-14);
}

/// What a scheme says that it bears is where its own matrix says so.
TEST(ContactMatrix, HoldsUpToTheLargestRateAndFrequency) {
  for_each_type<Schemes>([]<class S>(std::type_identity<S>) {
    bool const bears_any = std::isinf(S::largest_rate);
    EXPECT_LE(std::abs(factor(S{}, bears_any ? 1e9 : 0.999 * S::largest_rate)), 1) << S::name;
    if (!bears_any) {
      EXPECT_GT(std::abs(factor(S{}, 1.001 * S::largest_rate)), 1) << S::name;
    }
    auto const radius = [](double omega) {
      return ContactMatrix::of(S{}, undamped(omega * omega), 1).radius();
    };
    EXPECT_NEAR(radius(0.999 * S::largest_frequency), 1, 1e-12) << S::name;
    EXPECT_GT(radius(1.001 * S::largest_frequency), 1.01) << S::name;
  });
}

/// With both, the step that an ImplicitScheme bears is where its matrix says so.
TEST(ContactMatrix, HoldsUpToTheLargestTimeStep) {
  for (double const rate : {0.0, 0.3, 2.0, 40.0})
    for (double const frequency2 : {0.5, 2.0, 12.0}) {
      double const dt = ImplicitDamping::largest_time_step(rate, frequency2);
      auto const radius = [&](double share) {
        return ContactMatrix::of(ImplicitDamping{}, {frequency2, rate}, share * dt).radius();
      };
      EXPECT_LE(radius(0.999), 1 + 1e-12) << rate << ' ' << frequency2;
      EXPECT_GT(radius(1.001), 1) << rate << ' ' << frequency2;
    }
}

/// Without damping both torque_per_diameter by an angle with cos = 1 - (omega dt)^2/2 and keep the
/// area: by hand xx + vv = 2 - w^2 and xx vv - xv vx = 1.
TEST(ContactMatrix, OfAnOscillationByHand) {
  for_each_type<Schemes>([]<class S>(std::type_identity<S>) {
    for (double const w : {0.1, 0.5, 1.3}) {
      auto const m = ContactMatrix::of(S{}, undamped(w * w), 1);
      EXPECT_NEAR(m.xx + m.vv, 2 - w * w, 1e-14) << S::name;
      EXPECT_NEAR(m.xx * m.vv - m.xv * m.vx, 1, 1e-14) << S::name;
    }
  });
}

/// Disks that do not touch fly on.
TEST(LoneContact, OpensWhereThereIsNoOverlap) {
  LoneContact const contact{2, 1, true};
  for_each_type<Schemes>([&]<class S>(std::type_identity<S>) {
    auto const free = S::step({1, -0.5}, contact, 0.25);
    EXPECT_EQ(free.x, 0.875) << S::name;
    EXPECT_EQ(free.v, -0.5) << S::name;
    EXPECT_GT(S::step({-0.1, -0.5}, contact, 0.25).v, -0.5) << S::name;
  });
}

TEST(TypeList, FindsByName) {
  auto const is_papers = [](std::string_view name) {
    return with_named<Schemes>(
        name, []<class S>(std::type_identity<S>) { return std::is_same_v<S, Papers>; });
  };
  EXPECT_TRUE(is_papers("modified-velocity-verlet"));
  EXPECT_FALSE(is_papers("two-stage-leapfrog"));
  EXPECT_FALSE(is_papers("no such scheme"));
  EXPECT_EQ((names_of<std::tuple<Papers, TwoStage>>()),
            (std::vector<std::string_view>{papers_scheme, two_stage_scheme}));
}

}  // namespace
}  // namespace bagnold::test
