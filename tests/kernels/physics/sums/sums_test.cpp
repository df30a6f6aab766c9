// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/sums/sums.hpp"

#include <gtest/gtest.h>

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/in_time.hpp"

namespace bagnold::test {
namespace {

using C = SumColumns;
using simd::Pack;

/// r = (2, 3), f_el = (5, 7), f_dis = (11, 13), v = (-1, 2).
template <class T>
PairForce<T> pair_by_hand() {
  return {{2.0, 3.0}, {5.0, 7.0}, {11.0, 13.0}, 0.1, {-1.0, 2.0}};
}

void expect_pair(Real const* columns, Real times) {
  EXPECT_EQ(columns[C::elastic_xx], 10 * times);  // f_x r_x
  EXPECT_EQ(columns[C::elastic_xy], 15 * times);  // f_x r_y
  EXPECT_EQ(columns[C::elastic_yy], 21 * times);  // f_y r_y
  EXPECT_EQ(columns[C::dissipative_xx], 22 * times);
  EXPECT_EQ(columns[C::dissipative_xy], 33 * times);
  EXPECT_EQ(columns[C::dissipative_yx], 26 * times);
  EXPECT_EQ(columns[C::dissipative_yy], 39 * times);
  EXPECT_EQ(columns[C::dissipation], -15 * times);  // 11 - 26
}

TEST(PairColumns, ByHand) {
  Sums<false> sums;
  add_pair(sums.value, pair_by_hand<Real>(), 1);
  expect_pair(sums.value, 1);
  EXPECT_EQ(sums.value[C::contacts], 2);
  add_pair(sums.value, pair_by_hand<Real>(), 0.5);
  expect_pair(sums.value, 1.5);
  EXPECT_EQ(sums.value[C::contacts], 3);
  for (int const c : {C::kinetic_xx, C::kinetic_xy, C::kinetic_yy, C::velocity_x2, C::velocity_y2})
    EXPECT_EQ(sums.value[c], 0);
}

TEST(PairColumns, OfPacksAreThoseOfEachLane) {
  auto const of = columns_of(pair_by_hand<Pack>());
  for (int k = 0; k < simd::width; ++k) {
    Real lane[pair_columns];
    for (int c = 0; c < pair_columns; ++c) lane[c] = of.value[c].v[k];
    expect_pair(lane, 1);
  }
}

/// m = 3, v = (5, 2) at y = 4 with gammadot = 1/2: u = (3, 2); spin -2.
TEST(DiskColumns, ByHand) {
  Real const ux = peculiar_x<Real>(5, 4, 0.5);
  EXPECT_EQ(ux, 3);
  Sums<true> sums;
  add_motion(sums.value, Real(3), ux, Real(2));
  add_spin(sums.value, Real(-2));
  EXPECT_EQ(sums.value[C::kinetic_xx], 27);
  EXPECT_EQ(sums.value[C::kinetic_xy], 18);
  EXPECT_EQ(sums.value[C::kinetic_yy], 12);
  EXPECT_EQ(sums.value[C::velocity_x2], 9);
  EXPECT_EQ(sums.value[C::velocity_y2], 4);
  EXPECT_EQ(sums.value[C::spin], -2);
  EXPECT_EQ(sums.value[C::spin2], 4);
  EXPECT_EQ(sums.value[C::contacts], 0);
}

TEST(InTime, MultipliesLikePolynomials) {
  Linear<Real> const a{{1, 2}}, b{{3, -4}};
  Quadratic<Real> const ab = a * b;  // (1 + 2t)(3 - 4t) = 3 + 2t - 8t^2
  EXPECT_EQ(ab.c[0], 3);
  EXPECT_EQ(ab.c[1], 2);
  EXPECT_EQ(ab.c[2], -8);
  EXPECT_EQ(ab.over(4, 6, 14), 4 * 3 + 6 * 2 - 14 * 8);  // t = 0, 1, 2, 3
}

/// A flight's columns, added up from polynomials, are those of its disks at each time.
TEST(InTime, AFlightIsTheSumOverItsTimes) {
  Real const mass = 1.5, rate = 0.25, y0 = 2, vx = 0.75, vy = -1.25, dt = 0.5;
  Linear<Real> const ux{{peculiar_x(vx, y0, rate), -rate * vy}};
  Quadratic<Real> flight[C::count];
  add_motion(flight, mass, ux, vy);
  Sums<false> each;
  for (int k = 0; k < 4; ++k) {
    Real const y = y0 + k * dt * vy;
    add_motion(each.value, mass, peculiar_x(vx, y, rate), vy);
  }
  Real const sum_t = 6 * dt, sum_t2 = 14 * dt * dt;
  for (int const c : {C::kinetic_xx, C::kinetic_xy, C::kinetic_yy, C::velocity_x2, C::velocity_y2})
    EXPECT_NEAR(flight[c].over(4, sum_t, sum_t2), each.value[c], 1e-13) << c;
}

/// In packs too: the same formula with another number.
TEST(InTime, WorksInPacks) {
  Linear<Pack> const ux{{Pack(1.0), Pack(2.0)}};
  Quadratic<Pack> flight[C::count];
  add_motion(flight, Pack(2.0), ux, Pack(3.0));
  auto const last = simd::width - 1;
  EXPECT_EQ(flight[C::kinetic_xx].c[1].v[last], 8);  // 2 (1 + 2t)^2
  EXPECT_EQ(flight[C::kinetic_xx].c[2].v[last], 8);
  EXPECT_EQ(flight[C::kinetic_xy].c[1].v[last], 12);  // 2 * 3 (1 + 2t)
  EXPECT_EQ(flight[C::velocity_y2].c[0].v[last], 9);
}

}  // namespace
}  // namespace bagnold::test
