// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/device/dynamics/contact_forces.hpp"

#include "tests/kernels/device/dynamics/disk_contacts.hpp"

namespace bagnold::test {
namespace {

/// Where disk 0 is, and the image (m, n) of disk 1 that it touches.
struct Place {
  double x, y;
  int m, n;
};

/// Inside; across the left edge; across the lower one, and there past the offset to either side.
/// From disk 1 these are the right and the upper edge.
constexpr Place places[] = {
    {5.0, 5.0, 0, 0}, {0.2, 5.0, -1, 0}, {5.0, 0.3, 0, -1}, {0.3, 0.3, 0, -1}, {9.0, 0.3, 1, -1}};

constexpr double strain_rate = 0.1;

/// d_ij = 1.2, r_ij = 0.9 n, v_ij = (-0.2, 1.4) = n + t; n = (0.6, 0.8), t = z^ x n = (-0.8, 0.6).
/// The image of disk 1 is off by (m L + n gamma L, n L) and moves with n gammadot L more.
State pair_at(Place const& place) {
  State state;
  state.box_length = 10.0;
  state.offset = 2.5;
  state.position = {
      {place.x, place.y},
      {place.x - 0.54 - place.m * 10.0 - place.n * 2.5, place.y - 0.72 - place.n * 10.0}};
  state.velocity = {{0.1, 0.5}, {0.3 - place.n * strain_rate * 10.0, -0.9}};
  state.spin = {0.4, 0.2};
  state.diameter = {1.0, 1.4};
  return state;
}

/// For that pair at Q = 2: the dissipative force on disk 0 along n and t, and both torques.
///
/// P2 Eq. (6): v^C = v_ij - (0.4 * 1 + 0.2 * 1.4)/2.4 z^ x r_ij, and z^ x r_ij = 0.9 t, so that
/// v^C = 1 n + (1 - 0.255) t. P2 Eq. (7): torques s x f, with s_ji = -(1/2.4) r_ij on disk 0, and
/// s_ij = (1.4/2.4) r_ij and f_ji = -f_ij on disk 1; r_ij x f = 0.9 f_t: -0.375 f_t and -0.525 f_t.
struct ByHand {
  double normal, tangential, torque_0, torque_1;
};

/// A law without its numbers does not compile.
template <class Law>
constexpr ByHand by_hand() = delete;

template <>  // P2 Eq. (3)
constexpr ByHand by_hand<CD>() {
  return {-0.5, -0.5, 0.0, 0.0};
}
template <>  // P1 Eq. (3)
constexpr ByHand by_hand<CDn>() {
  return {-0.5, 0.0, 0.0, 0.0};
}
template <>  // P2 Eq. (5): f_t = -0.5 * 0.745
constexpr ByHand by_hand<CDrot>() {
  return {-0.5, -0.3725, 0.1396875, 0.1955625};
}
template <>  // P2 below Eq. (7), k_n = 0.7/2 and k_t = 1.6/2: f_t = -0.8 * 0.745
constexpr ByHand by_hand<CDnt>() {
  return {-0.35, -0.596, 0.2235, 0.3129};
}

}  // namespace

template <class LawOnSpace>
class ContactForcesOn : public ForcesOn<LawOnSpace> {
 public:
  static constexpr ByHand expected = by_hand<typename LawOnSpace::Law>();
};
TYPED_TEST_SUITE(ContactForcesOn, EveryLawOnEveryBackend, TypeNames);

TYPED_TEST(ContactForcesOn, AreThoseByHandAcrossEveryEdge) {
  Vec2<Real> const n{0.6, 0.8}, t{-0.8, 0.6};
  for (Place const& place : places) {
    State const state = pair_at(place);
    for (auto const& [x, y] : state.position) {  // the list is for disks in the box
      ASSERT_GE(std::min(x, y), 0.0);
      ASSERT_LT(std::max(x, y), state.box_length);
    }
    auto const on_disks = this->on_disks(state, strain_rate);
    for (int disk : {0, 1}) {
      double const sign = disk == 0 ? 1.0 : -1.0;
      auto const& f = on_disks[disk];
      EXPECT_EQ(f.contacts, 1);
      EXPECT_NEAR(sign * dot(f.elastic, n), 0.25 / 1.2, 1e-14);  // P1, P2 Eq. (2), alpha = 2
      EXPECT_NEAR(dot(f.elastic, t), 0.0, 1e-14);
      EXPECT_NEAR(sign * dot(f.dissipative, n), this->expected.normal, 1e-14);
      EXPECT_NEAR(sign * dot(f.dissipative, t), this->expected.tangential, 1e-14);
      EXPECT_EQ(f.load.force.x, f.elastic.x + f.dissipative.x);
      EXPECT_EQ(f.load.force.y, f.elastic.y + f.dissipative.y);
    }
    EXPECT_NEAR(on_disks[0].torque(), this->expected.torque_0, 1e-14);
    EXPECT_NEAR(on_disks[1].torque(), this->expected.torque_1, 1e-14);
  }
}

/// The dissipative force jumps where a contact opens: it must not act at d_ij any more. Disk 1 is
/// at x = 0, so that the separation is d_ij to the bit; the list has the pair all along.
TYPED_TEST(ContactForcesOn, EndAtTheContactDistance) {
  for (auto [d_0, d_1] : {std::pair{1.0, 1.0}, {1.0, 1.4}, {1.4, 1.4}}) {
    double const contact_distance = (d_0 + d_1) / 2;
    auto const at = [&](double distance) {
      State state;
      state.box_length = 10.0;
      state.position = {{distance, 5.0}, {0.0, 5.0}};
      state.velocity = {{-0.2, 0.0}, {0.0, 0.0}};
      state.spin = {0.0, 0.0};
      state.diameter = {d_0, d_1};
      return this->on_disks(state, strain_rate);
    };
    for (double beyond : {0.0, 1e-12, 0.2}) {
      for (auto const& on_disks : at(contact_distance + beyond)) {
        EXPECT_EQ(on_disks.contacts, 0);
        EXPECT_EQ(on_disks.load.force.x, 0.0);
        EXPECT_EQ(on_disks.load.force.y, 0.0);
        EXPECT_EQ(on_disks.torque(), 0.0);
      }
    }
    auto const touching = at(contact_distance - 1e-12);
    EXPECT_EQ(touching[0].contacts, 1);
    EXPECT_NEAR(touching[0].load.force.x, -0.2 * this->expected.normal, 1e-11);
    EXPECT_EQ(touching[1].load.force.x, -touching[0].load.force.x);
  }
}

TYPED_TEST(ContactForcesOn, AreThoseOfTheReferenceAtAnyStrain) {
  auto p = this->parameters();
  for (double strain : {0.0, 0.3, 0.999}) {
    for (std::size_t count : {24, 80, 200}) {
      State state = reference::scattered(count, count);
      state.offset = strain * state.box_length;
      auto const expect_same = [&](auto const& on_disks) {
        auto const expected = reference::forces_and_torques(p, state, strain);
        for (std::size_t i = 0; i < count; ++i) {
          EXPECT_NEAR(on_disks[i].load.force.x, expected[i][0], 1e-13);
          EXPECT_NEAR(on_disks[i].load.force.y, expected[i][1], 1e-13);
          EXPECT_NEAR(on_disks[i].torque(), expected[i][2], 1e-13);
        }
      };
      for_each_type<Repulsions>([&]<class R>(std::type_identity<R>) {
        p.force_exponent = R::force_exponent;
        expect_same(this->template on_disks<R>(state, p.strain_rate));
      });
    }
  }
}

}  // namespace bagnold::test
