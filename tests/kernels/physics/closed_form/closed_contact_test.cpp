// SPDX-License-Identifier: BSD-3-Clause
//
// Contacts in closed form against the equations of motion, integrated to 1e-15, and against what
// the papers say of them.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/kernels/physics/closed_form/two_disks.hpp"
#include "tests/reference/binary_collision.hpp"
#include "tests/reference/forces.hpp"

namespace bagnold::test {
namespace {

template <class Law>
Law law_at(Real elasticity) {
  return Law::make({elasticity, 0.7, 1.6});
}

constexpr Real elasticities[] = {500, 20, 1.5};

/// Small enough for terms of order e^2 to be below 1e-10.
constexpr Real slow = 2e-6;

/// Differences of a state from that of the equations: of velocities and spins over the speed of
/// approach, of positions over that and half a period.
template <class Law>
struct Error {
  Real velocity, position, spin;

  Error(TwoDisks<Law> const& disks, PairMotion<Law::rotates> const& found,
        typename Integrated<Law>::At const& at, Real speed) {
    auto const c = disks.contact_class();
    auto const pair = Integrated<Law>(disks).pair(at.y, at.time);
    auto const size = [](Long x, Long y) { return static_cast<Real>(std::hypot(x, y)); };
    velocity = size(pair.velocity.x - found.velocity.x, pair.velocity.y - found.velocity.y) / speed;
    position = size(pair.separation.x - found.separation.x, pair.separation.y - found.separation.y);
    position /= speed * c.half_period;
    spin = 0;
    if constexpr (Law::rotates)
      spin = size(at.y[4] - found.spin_i, at.y[9] - found.spin_j) * c.distance / speed;
  }
};

template <class Law>
class ClosedContacts : public testing::Test {};

template <class Law>
struct Typed;
template <class... Law>
struct Typed<std::tuple<Law...>> {
  using Types = testing::Types<Law...>;
};
TYPED_TEST_SUITE(ClosedContacts, typename Typed<Laws>::Types, );

/// The oracle's force is that of the papers.
TYPED_TEST(ClosedContacts, OracleHasThePapersForce) {
  using Law = TypeParam;
  for (auto const& [name, disks] : scenes(law_at<Law>(3), 0.03)) {
    reference::Parameters p;
    reference::set_law(p, Law::name, {});
    p.elasticity = 3;
    p.damping_normal = 0.7;
    p.damping_tangential = 1.6;
    p.strain_rate = disks.box.strain_rate;
    auto const image = disks.image_of_j();
    Vec2<Real> const closer = 0.05 * (image.position - disks.i.position);
    auto moved = disks;
    moved.i.position += closer;
    auto const pair = moved.pair();
    State s;
    s.diameter = {disks.table().diameter[disks.species_i], disks.table().diameter[disks.species_j]};
    Real spins = 0;
    if constexpr (Law::rotates) {
      s.spin = {pair.spin_i, pair.spin_j};
      spins = s.diameter[0] * pair.spin_i + s.diameter[1] * pair.spin_j;
    }
    Real const d = disks.contact_class().distance;
    reference::Contact const contact{0,
                                     1,
                                     0,
                                     0,
                                     pair.separation.x,
                                     pair.separation.y,
                                     pair.velocity.x,
                                     pair.velocity.y,
                                     std::sqrt(dot(pair.separation, pair.separation)),
                                     d};
    auto const expected = reference::pair_force(p, s, contact);
    auto const found = Integrated<Law>(moved).force({{pair.separation.x, pair.separation.y},
                                                     {pair.velocity.x, pair.velocity.y},
                                                     static_cast<Long>(spins)});
    EXPECT_NEAR(found.elastic.x, expected.elastic_x, 1e-15) << name;
    EXPECT_NEAR(found.elastic.y, expected.elastic_y, 1e-15) << name;
    EXPECT_NEAR(found.dissipative.x, expected.dissipative_x, 1e-16) << name;
    EXPECT_NEAR(found.dissipative.y, expected.dissipative_y, 1e-16) << name;
    if constexpr (Law::rotates) {
      auto const torque = found.torque_per_diameter(1 / static_cast<Long>(d));
      EXPECT_NEAR(torque * s.diameter[0], expected.torque_i, 1e-16) << name;
      EXPECT_NEAR(torque * s.diameter[1], expected.torque_j, 1e-16) << name;
    }
  }
}

TYPED_TEST(ClosedContacts, FollowTheEquations) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (auto const& [name, disks] : scenes(law_at<Law>(Q), slow)) {
      auto const c = disks.contact_class();
      auto const contact = disks.begin();
      Integrated<Law> const integrated(disks);
      auto const end = integrated.end(contact.duration);
      EXPECT_NEAR(contact.duration / static_cast<Real>(end.time), 1, 1e-10) << name << ", Q " << Q;
      Error<Law> const at_end(disks, contact.end, end, slow);
      EXPECT_LT(at_end.velocity, 1e-10) << name << ", Q " << Q;
      EXPECT_LT(at_end.position, 3e-10) << name << ", Q " << Q;  // 1e-15 of the distance
      EXPECT_LT(at_end.spin, 1e-10) << name << ", Q " << Q;
      auto at = integrated.start();
      for (Real part : {0.3, 0.7}) {
        Real const s = part * contact.duration;
        at = integrated.after(at, s - at.time, 50);
        Error<Law> const error(disks, contact.at(c, s), at, slow);
        EXPECT_LT(error.velocity, 1e-10) << name << ", Q " << Q;
        EXPECT_LT(error.position, 3e-10) << name << ", Q " << Q;
        EXPECT_LT(error.spin, 1e-10) << name << ", Q " << Q;
      }
    }
}

/// What is left out is of relative order e^2, e = v T/d_ij, with the factors that the docstring of
/// ClosedContact states.
TYPED_TEST(ClosedContacts, ErrorsFallAsTheSquareOfTheSpeed) {
  using Law = TypeParam;
  for (Real Q : elasticities) {
    auto const fast = scenes(law_at<Law>(Q), 1e-2), slower = scenes(law_at<Law>(Q), 1e-3);
    Real worst[2][5] = {};
    for (std::size_t k = 0; k < fast.size(); ++k)
      for (int n : {0, 1}) {
        auto const& disks = (n == 0 ? fast : slower)[k].disks;
        Real const speed = n == 0 ? 1e-2 : 1e-3;
        auto const c = disks.contact_class();
        Real const e = speed * c.half_period / c.distance;
        auto const contact = disks.begin();
        Integrated<Law> const integrated(disks);
        auto const end = integrated.end(contact.duration);
        auto const middle = integrated.after(integrated.start(), contact.duration / 2, 50);
        Error<Law> const last(disks, contact.end, end, speed);
        Error<Law> const half(disks, contact.at(c, contact.duration / 2), middle, speed);
        Real const late = std::fabs(static_cast<Real>(end.time - contact.duration));
        Real const errors[5] = {late / c.half_period, last.velocity, last.spin, half.velocity,
                                half.position};
        for (int q = 0; q < 5; ++q) worst[n][q] = std::max(worst[n][q], errors[q] / (e * e));
      }
    Real const stated[5] = {0.15, 0.03, 0.05, 0.1, 0.065};
    for (int q = 0; q < 5; ++q) {
      for (int n : {0, 1}) EXPECT_LT(worst[n][q], stated[q]) << "Q " << Q << ", " << q;
      if (q == 0 || q >= 3) {  // of exact order: the coefficient is the same at both speeds
        EXPECT_NEAR(worst[0][q] / worst[1][q], 1, 0.25) << "Q " << Q << ", " << q;
      }
    }
  }
}

/// T = pi/omega, e of P1 Eq. (7), and both normal velocities are exchanged by it, to rounding.
TYPED_TEST(ClosedContacts, HeadOnRestitutionIsThatOfThePaper) {
  using Law = TypeParam;
  for (Real Q : {1000.0, 10.0, 2.0, 1.1}) {
    for (auto const& [name, disks] : scenes(law_at<Law>(Q), 1e-4)) {
      if (name.find("head-on,") == std::string::npos || name.find("spin") != std::string::npos)
        continue;
      reference::Parameters p;
      reference::set_law(p, Law::name, {});
      p.elasticity = Q;
      p.damping_normal = 0.7;
      p.area_mass = disks.mass_by_area;
      auto const t = disks.table();
      reference::BinaryCollision const expected(p, t.diameter[disks.species_i],
                                                t.diameter[disks.species_j]);
      auto const contact = disks.begin();
      EXPECT_NEAR(contact.duration / expected.duration(), 1, 4e-15) << name << ", Q " << Q;
      Real const restitution = -contact.last.approach / contact.approach;
      EXPECT_NEAR(restitution / expected.restitution(), 1, 1e-13) << name << ", Q " << Q;
      for (Real part : {0.2, 0.6}) {
        Real const s = part * contact.duration;
        EXPECT_NEAR(
            contact.polar(disks.contact_class(), s).overlap / expected.overlap(contact.approach, s),
            1, 1e-13)
            << name << ", Q " << Q;
      }
    }
  }
}

TYPED_TEST(ClosedContacts, MomentaAreKeptToRounding) {
  using Law = TypeParam;
  Real const speed = 1e-2;
  for (Real Q : elasticities)
    for (auto const& scene : scenes(law_at<Law>(Q), speed)) {
      auto const& name = scene.name;
      auto const& disks = scene.disks;
      auto const c = disks.contact_class();
      auto const t = disks.table();
      auto const contact = disks.begin();
      auto const centre = c.centre(disks.i, disks.image_of_j());
      Real const m_i = disks.mass(disks.species_i), m_j = disks.mass(disks.species_j);
      auto const momenta = [&](Real s, PairMotion<Law::rotates> const& pair) {
        PairCentre const now{centre.position + s * centre.velocity, centre.velocity};
        auto const i = c.disk_i(now, pair), j = c.disk_j(now, pair);
        Vec2<Real> const linear = m_i * i.motion.velocity + m_j * j.motion.velocity;
        Real angular =
            m_i * cross(i.position, i.motion.velocity) + m_j * cross(j.position, j.motion.velocity);
        if constexpr (Law::rotates)
          angular += i.motion.spin / t.inverse_inertia[disks.species_i] +
                     j.motion.spin / t.inverse_inertia[disks.species_j];
        return std::array<Real, 3>{linear.x, linear.y, angular};
      };
      auto const first = momenta(0, disks.pair());
      for (Real part : {0.25, 0.6, 1.0}) {
        Real const s = part * contact.duration;
        auto const now = momenta(s, part == 1 ? contact.end : contact.at(c, s));
        EXPECT_NEAR(now[0], first[0], 1e-15 * speed * 20) << name;
        EXPECT_NEAR(now[1], first[1], 1e-15 * speed * 20) << name;
        if (Law::rotates || c.tangential_damping == 0) {  // CD exerts a torque on a pair
          EXPECT_NEAR(now[2], first[2], 1e-15 * speed * 100) << name;
        }
      }
    }
}

/// r_ij = d_ij at the end, the disks part, and no overlap is negative before.
TYPED_TEST(ClosedContacts, EndWhereTheDisksPart) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (Real speed : {1e-7, 1e-3, 3e-2})
      for (auto const& [name, disks] : scenes(law_at<Law>(Q), speed)) {
        auto const c = disks.contact_class();
        auto const contact = disks.begin();
        Real const r = std::sqrt(dot(contact.end.separation, contact.end.separation));
        EXPECT_NEAR(r / c.distance, 1, 4e-16) << name;
        EXPECT_GE(dot(contact.end.velocity, contact.end.separation), 0) << name;
        EXPECT_GT(contact.duration, 0) << name;
        Real const rounding = 1e-15 * speed * c.half_period;
        EXPECT_NEAR(contact.polar(c, contact.duration).overlap, 0, 4 * rounding) << name;
        for (int k = 1; k < 20; ++k)
          EXPECT_GT(contact.polar(c, k * contact.duration / 20).overlap, 0) << name;
      }
}

/// From any phase on a contact goes on as if it had not been asked: but for terms of order e^2.
TYPED_TEST(ClosedContacts, GoOnFromAnyPhase) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (Real speed : {1e-5, 1e-3})
      for (auto const& [name, disks] : scenes(law_at<Law>(Q), speed)) {
        auto const c = disks.contact_class();
        auto const contact = disks.begin();
        Real const e = speed * c.half_period / c.distance;
        Real const near = 0.2 * e * e + 1e-14 / speed;  // and rounding of r_ij
        for (Real part : {0.1, 0.5, 0.95}) {
          Real const s = part * contact.duration;
          auto const rest = ClosedContact<Law::rotates>::resume(c, contact.at(c, s));
          EXPECT_NEAR((s + rest.duration) / contact.duration, 1, near) << name << ", " << part;
          Vec2<Real> const change = rest.end.velocity - contact.end.velocity;
          EXPECT_LT(std::sqrt(dot(change, change)), near * speed) << name << ", " << part;
          if constexpr (Law::rotates) {
            EXPECT_NEAR(rest.end.spin_i, contact.end.spin_i, near * speed) << name;
            EXPECT_NEAR(rest.end.spin_j, contact.end.spin_j, near * speed) << name;
          }
        }
      }
}

/// The same contact, whether its end is looked for near half a period or anywhere.
TYPED_TEST(ClosedContacts, BothSearchesFindTheSameEnd) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (Real speed : {1e-6, 1e-4, 1e-3})
      for (auto const& [name, disks] : scenes(law_at<Law>(Q), speed)) {
        auto const c = disks.contact_class();
        auto const contact = disks.begin();
        auto touching = disks.pair();  // with an overlap of nothing
        Real const r = std::sqrt(dot(touching.separation, touching.separation));
        touching.separation = (c.distance / r) * touching.separation;
        auto const other = ClosedContact<Law::rotates>::resume(c, touching);
        Real const scale = contact.approach / speed;  // a touch of rounding moves the begin
        EXPECT_NEAR(other.duration / contact.duration, 1, 1e-15 / speed / scale + 1e-14) << name;
      }
}

/// Of any contact the first end is found, at most half a period on, and so is it from any phase:
/// grazing ones, disks that spin fast or against each other, near critical damping.
TYPED_TEST(ClosedContacts, OfAnyKindEndOnce) {
  using Law = TypeParam;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> unit(0, 1);
  std::normal_distribution<Real> normal;
  for (int n = 0; n < 20000; ++n) {
    Real const Q = 0.55 * std::pow(10.0, 3 * unit(random) * unit(random));
    auto const law = Law::make({Q, 0.3 + unit(random), 2 * unit(random)});
    auto const table = make_species_table(unit(random) < 0.5);
    auto const c = ContactClass<Law::rotates>::of_constants(
        law.normal_damping(), law.tangential_damping(), table, random() % 2, random() % 2);
    if (!c.underdamped()) continue;
    Real const speed = std::pow(10.0, -8 + 6 * unit(random));
    Real const slip = speed * normal(random) * std::pow(10.0, -4 * unit(random) * unit(random));
    Real const approach = speed * std::pow(10.0, -7 * unit(random) * unit(random));
    Real const angle = 6 * unit(random);
    Vec2<Real> const out{std::cos(angle), std::sin(angle)};
    PairMotion<Law::rotates> pair;
    pair.separation = c.distance * out;
    pair.velocity = slip * perpendicular(out) + (-approach) * out;
    if constexpr (Law::rotates) {
      pair.spin_i = 3 * speed * normal(random);
      pair.spin_j = 3 * speed * normal(random);
    }
    auto const contact = ClosedContact<Law::rotates>::begin(c, pair);
    auto const where = std::string(Law::name) + ", " + std::to_string(n);
    ASSERT_GT(contact.duration, 0) << where;
    ASSERT_LE(contact.duration, c.half_period * (1 + 1e-14)) << where;
    for (int k = 1; k < 12; ++k)
      EXPECT_GT(contact.polar(c, k * contact.duration / 12).overlap, -1e-21 * speed) << where;
    Real const s = unit(random) * contact.duration;
    auto const rest = ClosedContact<Law::rotates>::resume(c, contact.at(c, s));
    Real const e = speed * c.half_period / c.distance;
    Real const rounding = 1e-15 / (1e-15 - contact.last.approach);  // of r_ij
    EXPECT_NEAR(s + rest.duration, contact.duration, (30 * e * e + rounding) * c.half_period)
        << where;
  }
}

/// A chord of two disks that hardly touch: T = 2 u d/v_t^2.
TYPED_TEST(ClosedContacts, GrazingIsAChord) {
  using Law = TypeParam;
  for (auto disks : scenes(law_at<Law>(20), 1e-3)) {
    auto& two = disks.disks;
    auto const c = two.contact_class();
    auto pair = two.pair();
    Vec2<Real> const n = c.inverse_distance * pair.separation;
    Real const slip = 1e-3;
    for (Real u : {1e-12, 1e-9, 1e-7}) {
      pair.velocity = slip * perpendicular(n) + (-u) * n;
      if constexpr (Law::rotates) pair.spin_i = pair.spin_j = 0;
      auto const contact = ClosedContact<Law::rotates>::begin(c, pair);
      Real const chord = 2 * u * c.distance / (slip * slip);
      Real const rounding = 1e-15 * c.centrifugal_gain[0] * slip * slip / (u * chord);
      EXPECT_NEAR(contact.duration / chord, 1, 0.35 * chord + rounding)
          << disks.name << ", u " << u;
      EXPECT_NEAR(-contact.last.approach / u, 1, 3 * chord + rounding) << disks.name;
    }
  }
}

TYPED_TEST(ClosedContacts, DisksThatPartHaveNoTimeInContact) {
  using Law = TypeParam;
  for (auto const& [name, disks] : scenes(law_at<Law>(20), 1e-3)) {
    auto const c = disks.contact_class();
    auto pair = disks.pair();
    pair.velocity = Real(-1) * pair.velocity;
    for (auto const& contact : {ClosedContact<Law::rotates>::begin(c, pair),
                                ClosedContact<Law::rotates>::resume(c, pair)}) {
      if (contact.overlap > 0) continue;  // of rounding
      EXPECT_EQ(contact.duration, 0) << name;
      EXPECT_EQ(contact.end.velocity.x, pair.velocity.x) << name;
      EXPECT_EQ(contact.end.velocity.y, pair.velocity.y) << name;
    }
  }
}

TYPED_TEST(ClosedContacts, BoundsHold) {
  using Law = TypeParam;
  Real tightest[4] = {1e9, 1e9, 1e9, 1e9};
  for (Real Q : elasticities)
    for (Real speed : {1e-5, 1e-2})
      for (auto const& [name, disks] : scenes(law_at<Law>(Q), speed)) {
        auto const c = disks.contact_class();
        auto const contact = disks.begin();
        Integrated<Law> const integrated(disks);
        Real largest[4] = {};
        for (int k = 0; k <= 40; ++k) {
          Real const s = k * contact.duration / 40, left = contact.duration - s;
          auto const polar = contact.polar(c, s);
          auto const pair = contact.motion(c, polar);
          Vec2<Real> const apart =
              pair.separation - (contact.end.separation - left * contact.end.velocity);
          Real spins = 0;
          if constexpr (Law::rotates)
            spins = 2 * c.distance * (c.arm_i * pair.spin_i + c.arm_j * pair.spin_j);
          auto const f = integrated.force({{pair.separation.x, pair.separation.y},
                                           {pair.velocity.x, pair.velocity.y},
                                           static_cast<Long>(spins)});
          auto const total = f.elastic + f.dissipative;
          Real const values[4] = {polar.overlap, std::sqrt(dot(pair.velocity, pair.velocity)),
                                  static_cast<Real>(std::hypot(total.x, total.y)) / c.reduced_mass,
                                  std::sqrt(dot(apart, apart))};
          for (int q = 0; q < 4; ++q) largest[q] = std::max(largest[q], values[q]);
        }
        Real const bounds[4] = {contact.largest_overlap(), contact.largest_speed(c),
                                contact.largest_acceleration(c), contact.largest_deviation(c)};
        Real deepest = 0;
        for (int k = 0; k <= 2000; ++k)
          deepest = std::max(deepest, contact.polar(c, k * contact.duration / 2000).overlap);
        EXPECT_NEAR(contact.deepest_overlap(c), deepest, 1e-3 * deepest) << name << ", Q " << Q;
        EXPECT_GE(contact.deepest_overlap(c), deepest * (1 - 1e-12)) << name << ", Q " << Q;
        for (int q = 0; q < 4; ++q) {
          EXPECT_LE(largest[q], bounds[q] * (1 + 1e-9)) << name << ", Q " << Q << ", " << q;
          tightest[q] = std::min(tightest[q], bounds[q] / largest[q]);
        }
      }
  for (Real ratio : tightest) EXPECT_LT(ratio, 1.5);
}

/// An overdamped contact of two has no end.
TEST(ContactClasses, SayWhetherContactsEnd) {
  auto const ends = [](Real elasticity, bool by_area, Species i, Species j) {
    auto const table = make_species_table(by_area);
    return ContactClass<false>::of_constants(1 / elasticity, 0, table, i, j).underdamped();
  };
  EXPECT_TRUE(ends(0.565, true, 0, 0));  // P1, below Eq. (7): Q_d = 0.564
  EXPECT_FALSE(ends(0.564, true, 0, 0));
  EXPECT_TRUE(ends(0.565, true, 1, 1));  // d^2/mu is that of small ones
  EXPECT_TRUE(ends(0.708, false, 0, 0));
  EXPECT_FALSE(ends(0.707, false, 0, 0));
  EXPECT_TRUE(ends(0.991, false, 1, 1));
  EXPECT_FALSE(ends(0.989, false, 1, 1));
  for (auto const& [i, j] : {std::pair<Species, Species>{0, 0}, {0, 1}, {1, 1}})
    EXPECT_TRUE(ends(1, false, i, j));
  EXPECT_FALSE(ends(0.9, false, 1, 1));
}

/// CD_nt without friction is CD_n, and spins go on.
TEST(ContactClasses, NoFrictionIsCDn) {
  auto const with = scenes(CDnt{0.05, 0}, 1e-3);
  auto const without = scenes(CDn{0.05}, 1e-3);
  for (std::size_t k = 0; k < with.size(); ++k) {
    auto const rolling = with[k].disks.begin();
    auto const sliding = without[k].disks.begin();
    EXPECT_EQ(rolling.duration, sliding.duration);
    EXPECT_EQ(rolling.end.velocity.x, sliding.end.velocity.x);
    EXPECT_EQ(rolling.end.velocity.y, sliding.end.velocity.y);
    EXPECT_EQ(rolling.end.spin_i, with[k].disks.i.motion.spin);
    EXPECT_EQ(rolling.end.spin_j, with[k].disks.j.motion.spin);
  }
}

}  // namespace
}  // namespace bagnold::test
