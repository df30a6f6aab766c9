// SPDX-License-Identifier: BSD-3-Clause
//
// Integrals over contacts against the same sums of the equations of motion, integrated to 1e-15.
#include "kernels/physics/closed_form/contact_integrals.hpp"

#include <gtest/gtest.h>

#include "tests/kernels/physics/closed_form/two_disks.hpp"

namespace bagnold::test {
namespace {

template <class Law>
Law law_at(Real elasticity) {
  return Law::make({elasticity, 0.7, 1.6});
}

constexpr Real elasticities[] = {500, 20, 1.5};
constexpr Real slow = 2e-6;

/// All that ContactIntegrals gives, between two phases.
template <class Law>
struct Found {
  Sums<true> sums;
  ContactMotion motion;

  Found& add(TwoDisks<Law> const& disks, ClosedContact<Law::rotates> const& contact, Real from,
             Real until, Real weight = 1) {
    auto const c = disks.contact_class();
    ContactIntegrals<Law::rotates> const integrals{c};
    auto const centre = c.centre(disks.i, disks.image_of_j());
    integrals.over(contact, from, until, [&](auto const& nodes) {
      nodes.add_pair_columns(sums.value, weight);
      nodes.add_motion_columns(sums.value, centre, disks.mass(disks.species_i),
                               disks.mass(disks.species_j), disks.box.strain_rate, weight);
      nodes.add_contact_motion(motion, weight);
    });
    return *this;
  }
};

/// How large the columns of a contact are: that of its approach, over half a period.
template <class Law>
struct Scales {
  Real column[SumColumns::count_rotating], motion[ContactMotion::count];

  Scales(TwoDisks<Law> const& disks, Real speed) {
    using C = SumColumns;
    auto const c = disks.contact_class();
    Real const T = c.half_period, virial = c.reduced_mass * speed * c.distance;
    Real const energy = c.reduced_mass * speed * speed, all = 8 * energy;  // with the centre's
    for (int k = 0; k < C::dissipation; ++k) column[k] = virial;
    column[C::dissipation] = energy;
    for (int k : {C::kinetic_xx, C::kinetic_xy, C::kinetic_yy}) column[k] = all * T;
    column[C::contacts] = 2 * T;
    column[C::velocity_x2] = column[C::velocity_y2] = 4 * speed * speed * T;
    column[C::spin] = 2 * speed * T;
    column[C::spin2] = 4 * speed * speed * T;
    column[C::torque_power] = energy;
    using M = ContactMotion;
    for (int k = 0; k < M::tangential; ++k) motion[k] = speed * speed * T;
    for (int k = M::tangential; k < M::contacts; ++k) motion[k] = speed * T;
    motion[M::contacts] = T;
  }
};

/// Columns that a law has.
template <class Law>
constexpr int columns = Sums<Law::rotates>::columns;

template <class Law>
class OfContacts : public testing::Test {};

template <class Law>
struct Typed;
template <class... Law>
struct Typed<std::tuple<Law...>> {
  using Types = testing::Types<Law...>;
};
TYPED_TEST_SUITE(OfContacts, typename Typed<Laws>::Types, );

template <class Law>
void expect_near(TwoDisks<Law> const& disks, Found<Law> const& found,
                 typename Integrated<Law>::Sums const& expected, Real speed, Real near,
                 std::string const& where) {
  Scales<Law> const scales(disks, speed);
  for (int k = 0; k < columns<Law>; ++k)
    EXPECT_NEAR(found.sums.value[k],
                static_cast<Real>(expected.column[static_cast<std::size_t>(k)]),
                near * scales.column[k])
        << where << ", column " << k;
  for (int k = 0; k < ContactMotion::count; ++k)
    EXPECT_NEAR(found.motion.value[k],
                static_cast<Real>(expected.motion[static_cast<std::size_t>(k)]),
                near * scales.motion[k])
        << where << ", motion " << k;
}

TYPED_TEST(OfContacts, AreThoseOfTheEquations) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (auto const& [name, disks] : scenes(law_at<Law>(Q), slow)) {
      auto const contact = disks.begin();
      auto const where = name + ", Q " + std::to_string(Q);
      Integrated<Law> const integrated(disks);
      expect_near(disks, Found<Law>().add(disks, contact, 0, contact.duration),
                  integrated.end(contact.duration).sums, slow, 1e-10, where);
      // and of a part
      Real const from = 0.2 * contact.duration, until = 0.75 * contact.duration;
      auto begin = integrated.after(integrated.start(), from, 40);
      begin.sums = {};
      expect_near(disks, Found<Law>().add(disks, contact, from, until),
                  integrated.after(begin, until - begin.time).sums, slow, 1e-10, where + ", part");
    }
}

TYPED_TEST(OfContacts, ErrorsFallAsTheSquareOfTheSpeed) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (Real speed : {1e-2, 1e-3})
      for (auto const& [name, disks] : scenes(law_at<Law>(Q), speed)) {
        auto const c = disks.contact_class();
        auto const contact = disks.begin();
        Real const e = speed * c.half_period / c.distance;
        expect_near(disks, Found<Law>().add(disks, contact, 0, contact.duration),
                    Integrated<Law>(disks).end(contact.duration).sums, speed, 0.3 * e * e + 1e-10,
                    name + ", Q " + std::to_string(Q));
      }
}

/// p_dis = 0 over whole contacts, in every law: 2 p_dis is the integral of k_n r r'.
TYPED_TEST(OfContacts, DissipativePressureIsNothingToRounding) {
  using Law = TypeParam;
  using C = SumColumns;
  for (Real Q : elasticities)
    for (Real speed : {1e-6, 1e-2})
      for (auto const& [name, disks] : scenes(law_at<Law>(Q), speed)) {
        auto const contact = disks.begin();
        auto const found = Found<Law>().add(disks, contact, 0, contact.duration);
        Real const trace =
            found.sums.value[C::dissipative_xx] + found.sums.value[C::dissipative_yy];
        EXPECT_NEAR(trace, 0, 1e-15 * Scales<Law>(disks, speed).column[C::dissipative_xx]) << name;
        if (name.find("head-on,") == std::string::npos) continue;
        if (name.find("spin") != std::string::npos) continue;
        for (int k = C::dissipative_xx; k <= C::dissipative_yy; ++k)
          EXPECT_NEAR(found.sums.value[k], 0, 1e-15 * Scales<Law>(disks, speed).column[k]) << name;
      }
}

/// What disks lose of energy is what is dissipated, to rounding: over whole contacts of the kinetic
/// energy of both, in parts with what the overlap holds.
TYPED_TEST(OfContacts, DissipateWhatTheDisksLose) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (auto const& scene : scenes(law_at<Law>(Q), 1e-2)) {
      auto const& name = scene.name;
      auto const& disks = scene.disks;
      auto const c = disks.contact_class();
      auto const t = disks.table();
      auto const contact = disks.begin();
      auto const centre = c.centre(disks.i, disks.image_of_j());
      auto const energy = [&](PairMotion<Law::rotates> const& pair) {
        auto const i = c.disk_i(centre, pair), j = c.disk_j(centre, pair);
        Real const r = std::sqrt(dot(pair.separation, pair.separation));
        Real const overlap = std::max(1 - r / c.distance, 0.0);
        Real sum = disks.mass(disks.species_i) * dot(i.motion.velocity, i.motion.velocity) +
                   disks.mass(disks.species_j) * dot(j.motion.velocity, j.motion.velocity) +
                   overlap * overlap;
        if constexpr (Law::rotates)
          sum += i.motion.spin * i.motion.spin / t.inverse_inertia[disks.species_i] +
                 j.motion.spin * j.motion.spin / t.inverse_inertia[disks.species_j];
        return sum / 2;
      };
      Real const before = energy(contact.at(c, 0)), rounding = 4e-15 * before;
      auto const dissipated = [&](Real s) {
        return Found<Law>().add(disks, contact, 0, s).sums.value[SumColumns::dissipation];
      };
      EXPECT_NEAR(dissipated(contact.duration), before - energy(contact.end), rounding) << name;
      Real const half = contact.duration / 2;
      Real const of_overlap = 1e-15 * contact.largest_overlap();
      EXPECT_NEAR(dissipated(half), before - energy(contact.at(c, half)), rounding + of_overlap)
          << name;
    }
}

/// Virial theorem: d/dt (mu r_a v_b) = mu v_a v_b + r_a f_b.
TYPED_TEST(OfContacts, ObeyTheVirialTheorem) {
  using Law = TypeParam;
  using C = SumColumns;
  using M = ContactMotion;
  for (Real Q : elasticities)
    for (auto const& [name, disks] : scenes(law_at<Law>(Q), slow)) {
      auto const c = disks.contact_class();
      auto const contact = disks.begin();
      auto const found = Found<Law>().add(disks, contact, 0, contact.duration);
      auto const& v = found.sums.value;
      Real const change = dot(contact.end.separation, contact.end.velocity) -
                          dot(disks.pair().separation, disks.pair().velocity);
      Real const kinetic = found.motion.value[M::normal2] + found.motion.value[M::tangential2];
      Real const virial =
          v[C::elastic_xx] + v[C::elastic_yy] + v[C::dissipative_xx] + v[C::dissipative_yy];
      Real const scale = Scales<Law>(disks, slow).column[C::elastic_xx];
      EXPECT_NEAR(c.reduced_mass * (change - kinetic), virial, 1e-10 * scale)
          << name << ", Q " << Q;
    }
}

/// A part that is taken back leaves the rest, and parts add up.
TYPED_TEST(OfContacts, AddUp) {
  using Law = TypeParam;
  for (Real Q : elasticities)
    for (auto const& [name, disks] : scenes(law_at<Law>(Q), 1e-3)) {
      auto const contact = disks.begin();
      Real const T = contact.duration, s = 0.37 * T;
      auto const first = Found<Law>().add(disks, contact, 0, s);
      auto const cut = Found<Law>().add(disks, contact, 0, T).add(disks, contact, s, T, -1);
      Scales<Law> const scales(disks, 1e-3);
      for (int k = 0; k < columns<Law>; ++k)
        EXPECT_NEAR(first.sums.value[k], cut.sums.value[k], 2e-10 * scales.column[k])
            << name << ", Q " << Q << ", column " << k;
      for (int k = 0; k < ContactMotion::count; ++k)
        EXPECT_NEAR(first.motion.value[k], cut.motion.value[k], 2e-10 * scales.motion[k])
            << name << ", Q " << Q << ", motion " << k;
    }
}

/// Contacts near critical damping last long and are integrated in pieces.
TYPED_TEST(OfContacts, OfStrongDampingAreRightToo) {
  using Law = TypeParam;
  for (auto const& [name, disks] : scenes(law_at<Law>(0.72), slow)) {
    auto const c = disks.contact_class();
    if (!c.underdamped()) continue;
    auto const contact = disks.begin();
    expect_near(
        disks, Found<Law>().add(disks, contact, 0, contact.duration),
        Integrated<Law>(disks).after(Integrated<Law>(disks).start(), contact.duration, 300).sums,
        slow, 1e-9, name);
  }
}

}  // namespace
}  // namespace bagnold::test
