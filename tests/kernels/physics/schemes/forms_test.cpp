// SPDX-License-Identifier: BSD-3-Clause
//
// What engines take for granted of a scheme: a disk without force flies r + v dt, bit for bit.
#include "kernels/physics/schemes/forms.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/schemes/chebyshev.hpp"
#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"

namespace bagnold::test {
namespace {

using simd::Pack;

bool same(Real a, Real b) { return a == b; }
bool same(Pack const& a, Pack const& b) {
  for (int k = 0; k < simd::width; ++k)
    if (a.v[k] != b.v[k]) return false;
  return true;
}
template <class T>
bool same(Vec2<T> const& a, Vec2<T> const& b) {
  return same(a.x, b.x) && same(a.y, b.y);
}

struct Free {
  std::mt19937_64 random{5};
  std::normal_distribution<Real> normal;

  template <class T>
  T number() {
    T value{};
    if constexpr (std::is_same_v<T, Pack>)
      for (int k = 0; k < simd::width; ++k) value.v[k] = normal(random);
    else
      value = normal(random);
    return value;
  }

  /// One disk after another of a scheme, in T.
  template <class S, class T>
  void expect_straight() {
    for (int trial = 0; trial < 100; ++trial) {
      Vec2<T> const r{number<T>(), number<T>()}, v{number<T>(), number<T>()};
      Vec2<T> const none{T(0.0), T(0.0)};
      T const spin = number<T>(), still = T(0.0);
      T const dt = T(0.2 * (1 + trial)), per_mass = T(0.3) * dt;
      auto const reached = flown(r, v, dt);
      if constexpr (PredictCorrectScheme<S>) {
        EXPECT_TRUE(same(S::trial_position(r, v, dt), reached)) << S::name;
        EXPECT_TRUE(same(S::trial_velocity(v, none, per_mass), v)) << S::name;
        EXPECT_TRUE(same(S::trial_velocity(spin, still, per_mass), spin)) << S::name;
        EXPECT_TRUE(same(S::velocity(v, v, none, T(0.5) * per_mass), v)) << S::name;
        EXPECT_TRUE(same(S::velocity(spin, spin, still, T(0.5) * per_mass), spin)) << S::name;
        EXPECT_TRUE(same(S::position(r, v, v, T(0.5) * dt), reached)) << S::name;
      } else if constexpr (ImplicitScheme<S>) {
        ChebyshevIterations const plan(28.8, S::terms(true), S::lift);
        EXPECT_TRUE(same(S::change(none, per_mass), none)) << S::name;
        for (int k = 0; k < plan.count; ++k)
          EXPECT_TRUE(same(plan.iteration[k](none, none, per_mass, none), none)) << S::name;
        EXPECT_TRUE(same(S::velocity(v, none), v)) << S::name;
        EXPECT_TRUE(same(S::velocity(spin, still), spin)) << S::name;
        EXPECT_TRUE(same(S::position(r, v, dt), reached)) << S::name;
      } else {
        EXPECT_TRUE(same(S::change(none, per_mass), none)) << S::name;
        EXPECT_TRUE(same(S::velocity(v, none, none, per_mass), v)) << S::name;
        EXPECT_TRUE(same(S::velocity(spin, still, still, per_mass), spin)) << S::name;
        EXPECT_TRUE(same(S::velocity_of_pair(v, none, per_mass), v)) << S::name;
        EXPECT_TRUE(same(S::position(r, v, dt), reached)) << S::name;
      }
    }
  }
};

TEST(Forms, ADiskWithoutForceFliesStraight) {
  for_each_type<Schemes>([]<class S>(std::type_identity<S>) {
    Free{}.expect_straight<S, Real>();
    Free{}.expect_straight<S, Pack>();
  });
}

/// What a disk alone does, a contact that does not act does.
TEST(Forms, TheStepOfALoneContactIsThatOfTheForm) {
  LoneContact const contact{0.7, 0.3};
  RelativeMotion const q{-0.1, 0.4};
  Real const dt = 0.2;
  auto const f = [&](Real x, Real v) { return contact.acceleration({x, v}); };
  for_each_type<Schemes>([&]<class S>(std::type_identity<S>) {
    Real x, v;
    if constexpr (PredictCorrectScheme<S>) {
      Real const trial = S::trial_velocity(q.v, f(q.x, q.v), dt);
      v = S::velocity(q.v, trial, f(S::trial_position(q.x, q.v, dt), trial), dt / 2);
      x = S::position(q.x, q.v, v, dt / 2);
    } else if constexpr (ImplicitScheme<S>) {
      Real const w = S::change(f(q.x, q.v), dt) / (1 + S::theta * contact.damping * dt);
      v = S::velocity(q.v, w);
      x = S::position(q.x, v, dt);
    } else {
      Real const change = S::change(f(q.x, q.v), dt);
      Real const second = -contact.damping * S::share(contact.damping * dt) * change;
      v = S::velocity(q.v, change, second, dt);
      x = S::position(q.x, v, dt);
    }
    auto const stepped = S::step(q, contact, dt);
    EXPECT_NEAR(stepped.x, x, 1e-15) << S::name;
    EXPECT_NEAR(stepped.v, v, 1e-15) << S::name;
  });
}

}  // namespace
}  // namespace bagnold::test
