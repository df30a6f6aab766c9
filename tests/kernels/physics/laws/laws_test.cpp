// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/engine/device_copy.hpp"
#include "tests/support/typed.hpp"

namespace bagnold::test {
namespace {

constexpr Contact<Real> contact_of(Vec2<Real> const& normal, Vec2<Real> const& velocity,
                                   double relative_overlap, double contact_distance) {
  return {normal, velocity, relative_overlap, 1 / contact_distance};
}

/// The contact all numbers by hand are for: r_ij = 0.9 n, d_ij = 1.2, and the law's velocity is
/// 1 n + 2 t, with n = (0.6, 0.8) and the tangent t = z^ x n = (-0.8, 0.6): (-1.0, 2.0).
constexpr Contact<Real> by_hand = contact_of({0.6, 0.8}, {-1.0, 2.0}, 0.25, 1.2);

/// f_dis of that contact at Q = 2, k_d = 1/2; a law without its numbers does not compile.
template <class Law>
Vec2<Real> expected_force() = delete;

template <>  // P2 Eq. (3): -1/2 (-1, 2)
Vec2<Real> expected_force<CD>() {
  return {0.5, -1.0};
}
template <>  // P1 Eq. (3): -1/2 * 1 n
Vec2<Real> expected_force<CDn>() {
  return {-0.3, -0.4};
}
template <>  // P2 Eq. (5), the velocity being that at the point of contact: -1/2 (-1, 2)
Vec2<Real> expected_force<CDrot>() {
  return {0.5, -1.0};
}
template <>  // P2 below Eq. (7) with k_n = 0.7/2, k_t = 1.6/2: -0.35 * 1 n - 0.8 * 2 t
Vec2<Real> expected_force<CDnt>() {
  return {-0.21 + 1.28, -0.28 - 0.96};
}

/// Contacts in every direction with velocities of every size.
std::vector<Contact<Real>> random_contacts() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  std::vector<Contact<Real>> contacts(1000);
  for (auto& c : contacts) {
    double const angle = 2 * 3.14159265358979 * unit(random);
    double const speed = std::pow(10.0, -6 * unit(random));
    c = contact_of({std::cos(angle), std::sin(angle)},
                   {speed * normal(random), speed * normal(random)}, unit(random), 1.2);
  }
  return contacts;
}

template <class Space, class Law>
std::vector<Vec2<Real>> dissipative_forces(Law const& law,
                                           std::vector<Contact<Real>> const& contacts) {
  auto const contact = to_device<Space>("test::contact", contacts);
  Kokkos::View<Vec2<Real>*, Space> const force("test::force", contacts.size());
  Kokkos::parallel_for(
      "test::dissipative_force", Kokkos::RangePolicy<Space>(0, contacts.size()),
      KOKKOS_LAMBDA(std::int64_t k) { force(k) = law.dissipative_force(contact(k)); });
  return to_host(force);
}

template <class Space, class Repulsion>
double magnitude(Repulsion const& repulsion, Contact<Real> const& contact) {
  double result = 0.0;
  Kokkos::parallel_reduce(
      "test::magnitude", Kokkos::RangePolicy<Space>(0, 1),
      KOKKOS_LAMBDA(std::int64_t, double& sum) { sum += repulsion.magnitude(contact); }, result);
  return result;
}

/// Rounding of a force of order |v|.
double rounding(Contact<Real> const& c) { return 1e-15 * std::hypot(c.velocity.x, c.velocity.y); }

}  // namespace

template <class LawOnSpace>
class LawOn : public testing::Test {
 public:
  using Law = typename LawOnSpace::Law;
  using Space = typename LawOnSpace::Space;

  static auto forces(Law const& law, std::vector<Contact<Real>> const& contacts) {
    return dissipative_forces<Space>(law, contacts);
  }
};
TYPED_TEST_SUITE(LawOn, EveryLawOnEveryBackend, TypeNames);

TYPED_TEST(LawOn, GivesTheForceByHand) {
  using Law = typename TypeParam::Law;
  auto const force = this->forces(law_at<Law>(2.0), {by_hand}).front();
  EXPECT_NEAR(force.x, expected_force<Law>().x, 1e-15);
  EXPECT_NEAR(force.y, expected_force<Law>().y, 1e-15);
}

/// Damping takes energy, never gives any; a force is as large as its velocity, and turns with it.
TYPED_TEST(LawOn, TakesEnergyAndIsLinearInTheVelocity) {
  using Law = typename TypeParam::Law;
  auto const contacts = random_contacts();
  auto doubled = contacts;
  for (auto& c : doubled) c.velocity = Real(-2) * c.velocity;
  auto const force = this->forces(law_at<Law>(0.5), contacts);
  auto const opposite = this->forces(law_at<Law>(0.5), doubled);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_LT(dot(force[k], contacts[k].velocity), 0.0);
    EXPECT_EQ(opposite[k].x, -2 * force[k].x);
    EXPECT_EQ(opposite[k].y, -2 * force[k].y);
  }
}

/// CD_n along the normal; CD and CD_rot along the velocity; at k_d = 1/Q times the part they damp.
/// The law says so.
TYPED_TEST(LawOn, PointsAgainstWhatItDamps) {
  using Law = typename TypeParam::Law;
  auto const contacts = random_contacts();
  auto const law = law_at<Law>(4.0);
  auto const force = this->forces(law, contacts);
  EXPECT_TRUE(Law::linear);
  EXPECT_EQ(Law::one_constant, !(std::is_same_v<Law, CDnt>));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    auto const& c = contacts[k];
    Vec2<Real> const tangent{-c.normal.y, c.normal.x};
    double const along_normal = -4.0 * dot(force[k], c.normal) / dot(c.velocity, c.normal);
    double const tangential = dot(force[k], tangent), sliding = dot(c.velocity, tangent);
    double const rounding_n =
        1e-14 * std::hypot(c.velocity.x, c.velocity.y) / std::abs(dot(c.velocity, c.normal));
    double const damped_n = std::is_same_v<Law, CDnt> ? 0.7 : 1.0;
    double const damped_t = std::is_same_v<Law, CDn> ? 0.0 : std::is_same_v<Law, CDnt> ? 1.6 : 1.0;
    EXPECT_EQ(4 * law.normal_damping(), damped_n);
    EXPECT_EQ(4 * law.tangential_damping(), damped_t);
    EXPECT_NEAR(along_normal, damped_n, rounding_n);
    EXPECT_NEAR(-4.0 * tangential, damped_t * sliding, 10 * rounding(c));
  }
}

template <class Space>
class LawsOn : public testing::Test {};
TYPED_TEST_SUITE(LawsOn, EveryBackend, TypeNames);

TYPED_TEST(LawsOn, GeneralEndsInCDnAndCDrot) {
  auto const contacts = random_contacts();
  auto const only_normal = dissipative_forces<TypeParam>(CDnt{0.3, 0.0}, contacts);
  auto const cd_n = dissipative_forces<TypeParam>(CDn{0.3}, contacts);
  auto const both = dissipative_forces<TypeParam>(CDnt{0.3, 0.3}, contacts);
  auto const cd_rot = dissipative_forces<TypeParam>(CDrot{0.3}, contacts);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_NEAR(only_normal[k].x, cd_n[k].x, rounding(contacts[k]));
    EXPECT_NEAR(only_normal[k].y, cd_n[k].y, rounding(contacts[k]));
    EXPECT_EQ(both[k].x, cd_rot[k].x);
    EXPECT_EQ(both[k].y, cd_rot[k].y);
  }
}

/// (k_e/d_ij)(1 - r/d_ij)^(alpha - 1), P1 and P2 Eq. (2), at an overlap of 1/4 and d_ij = 1.2:
/// alpha = 2: (1/4)/1.2 = 5/24; alpha = 5/2: (1/8)/1.2 = 5/48.
TYPED_TEST(LawsOn, RepulsionByHand) {
  EXPECT_NEAR(magnitude<TypeParam>(HarmonicRepulsion{}, by_hand), 5.0 / 24, 1e-16);
  EXPECT_NEAR(magnitude<TypeParam>(HertzianRepulsion{}, by_hand), 5.0 / 48, 1e-16);
}

TYPED_TEST(LawsOn, RepulsionIsThePowerOfTheOverlap) {
  auto const check = [](auto repulsion) {
    double const exponent = decltype(repulsion)::force_exponent - 1.0;
    for (double distance : {1.0, 1.2, 1.4}) {
      for (double overlap : {0.0, 1e-9, 1e-3, 0.2, 0.9}) {
        auto const contact = contact_of(by_hand.normal, by_hand.velocity, overlap, distance);
        double const expected = std::pow(overlap, exponent) / distance;
        EXPECT_NEAR(magnitude<TypeParam>(repulsion, contact), expected, 1e-15 * expected);
      }
    }
  };
  check(HarmonicRepulsion{});
  check(HertzianRepulsion{});
}

}  // namespace bagnold::test
