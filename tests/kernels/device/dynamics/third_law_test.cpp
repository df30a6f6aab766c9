// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kernels/device/dynamics/disk_contacts.hpp"

namespace bagnold::test {
namespace {

/// Disks 2k and 2k + 1 touch, and no others: pairs at every angle and depth, all over a sheared box
/// and across its edges.
State lonely_pairs(reference::Parameters const& p) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  State state;
  double const spacing = 5.0;  // more than three reaches of 1.4
  state.box_length = 14 * spacing;
  state.offset = unit(random) * state.box_length;
  for (int k = 0; k < 14 * 14; ++k) {
    double const x = spacing * (k % 14), y = spacing * (k / 14);
    double const d_i = random() % 2 ? 1.0 : 1.4, d_j = random() % 2 ? 1.0 : 1.4;
    double const r = (d_i + d_j) / 2 * (0.05 + 0.94 * unit(random));
    double const angle = 6.28318530717958 * unit(random);
    state.position.push_back({x, y});
    state.position.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
    for (double d : {d_i, d_j}) {
      state.diameter.push_back(d);
      state.velocity.push_back({unit(random) - 0.5, unit(random) - 0.5});
      state.spin.push_back(unit(random) - 0.5);
    }
  }
  reference::wrap(p, state, state.offset / state.box_length);
  return state;
}

}  // namespace

template <class LawOnSpace>
class ThirdLawOn : public ForcesOn<LawOnSpace> {};
TYPED_TEST_SUITE(ThirdLawOn, EveryLawOnEveryBackend, TypeNames);

/// Each disk works out its own half of a pair, from its own row.
TYPED_TEST(ThirdLawOn, PairsFeelExactNegatives) {
  auto p = this->parameters();
  for (double rate : {0.0, 0.05, -0.3}) {
    p.strain_rate = rate;
    State const state = lonely_pairs(p);
    auto const on_disks = this->on_disks(state, rate);
    for (std::size_t i = 0; i < on_disks.size(); i += 2) {
      ASSERT_EQ(on_disks[i].contacts, 1);
      ASSERT_EQ(on_disks[i + 1].contacts, 1);
      EXPECT_EQ(on_disks[i].load.force.x, -on_disks[i + 1].load.force.x);
      EXPECT_EQ(on_disks[i].load.force.y, -on_disks[i + 1].load.force.y);
    }
  }
}

/// d/dt (orbital + spin angular momentum) = r_ij x f_ij + torques on both.
TYPED_TEST(ThirdLawOn, PairsKeepTheirAngularMomentum) {
  auto const p = this->parameters();
  if (p.model == Model::CD) GTEST_SKIP() << "CD has no spins to take up its torques";
  auto const on_disks = this->on_disks(lonely_pairs(p), p.strain_rate);
  for (std::size_t i = 0; i < on_disks.size(); i += 2)
    EXPECT_NEAR(on_disks[i].moment + on_disks[i].torque() + on_disks[i + 1].torque(), 0.0, 1e-15);
}

/// A heap in the middle of a wide box, where no image acts.
TYPED_TEST(ThirdLawOn, HeapsKeepTheirMomenta) {
  State state = reference::scattered(60, 2);
  for (auto& [x, y] : state.position) x += 10.0, y += 10.0;
  state.box_length += 20.0;
  auto const on_disks = this->on_disks(state, 0.0);
  Vec2<Real> force;
  double turning = 0.0;
  int contacts = 0;
  for (std::size_t i = 0; i < state.count(); ++i) {
    force += on_disks[i].load.force;
    turning += cross(vectors(state.position)[i], on_disks[i].load.force) + on_disks[i].torque();
    contacts += on_disks[i].contacts;
  }
  EXPECT_GT(contacts, 100);
  EXPECT_NEAR(force.x, 0.0, 1e-13);
  EXPECT_NEAR(force.y, 0.0, 1e-13);
  if (this->parameters().model != Model::CD) {  // no spins to take up the torque of its force
    EXPECT_NEAR(turning, 0.0, 1e-12);
  }
}

}  // namespace bagnold::test
