// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/profiles.hpp"

#include <gtest/gtest.h>

#include "tests/measure/seen.hpp"
#include "tests/measure/states.hpp"

namespace bagnold {
namespace {

constexpr double rate = 1e-3;
constexpr double L = 60.0;          // 40 slices, 1.5 thick
constexpr double share = 0.3;       // of the fast band: 12 slices
constexpr double slow_rate = 2e-4;  // and so the fast one, share fast + (1 - share) slow = rate
constexpr double fast_rate = (rate - (1 - share) * slow_rate) / share;

/// v_x - gammadot y of a band about `centre`: piecewise linear, periodic.
double band_excess(double y, double centre) {
  double const h = test::around(y, centre, L), half = share * L / 2;
  if (std::abs(h) <= half) return (fast_rate - rate) * h;
  return (slow_rate - rate) * (h - std::copysign(L / 2, h));
}

/// Rows three to a slice, every second disk left out inside the band; v_y = +-agitation in turn.
State band_state(double centre, double agitation = 0.0) {
  State state;
  state.box_length = L;
  state.strain_rate = rate;
  for (int row = 0; row < 120; ++row) {
    double const y = (row + 0.5) * 0.5;
    bool const thin = std::abs(test::around(y, centre, L)) < share * L / 2;
    for (int k = 0; k < 24; k += thin ? 2 : 1) {
      state.position.push_back({(k + 0.5) * 2.5, y});
      state.velocity.push_back({rate * y + band_excess(y, centre),
                                (k / (thin ? 2 : 1)) % 2 == 0 ? agitation : -agitation});
      state.diameter.push_back(1.0);
    }
  }
  return state;
}

double packing_fraction(State const& state) {
  return static_cast<double>(state.count()) * std::numbers::pi / 4 / (L * L);
}

test::Seen profiles_of(std::vector<State> const& states) {
  Scene scene = test::plain_scene("CD_n", rate);
  scene.disks.packing_fraction = packing_fraction(states.front());
  Profiles profiles(scene, Slices(L, L));
  for (auto const& state : states) profiles.add({state, 0, 0.0});
  return test::seen_by({&profiles});
}

TEST(Profiles, OfLinearFlow) {
  auto const results = [] {
    Profiles profiles(test::plain_scene("CD_n", rate), Slices(L, L));
    State const state = test::square_lattice(48, 1.25, rate);
    profiles.add({state, 0, 0.0});
    FrameResults found;
    profiles.report({&profiles}, found);
    return found;
  }();
  auto const& v_x = test::named(results.profiles, "v_x");
  for (std::size_t b = 0; b < v_x.y.size(); ++b) {
    EXPECT_NEAR(v_x.y[b], (static_cast<double>(b) + 0.5) * 1.5, 1e-12);
    EXPECT_NEAR(v_x.value[b], rate * v_x.y[b], 1e-15);
    EXPECT_NEAR(test::named(results.profiles, "gammadot").value[b], rate, 1e-15);
    EXPECT_NEAR(test::named(results.profiles, "p_kin").value[b], 0.0, 1e-15);
    EXPECT_TRUE(std::isnan(v_x.error[b])) << "one frame has no error";
  }
}

TEST(Profiles, OfAHandMadeBand) {
  auto const results = profiles_of({band_state(L / 2)});
  auto const& flow = test::named(results.profiles, "gammadot");
  auto const& phi = test::named(results.profiles, "phi");
  double const dense = 24 * 3 * std::numbers::pi / 4 / (L * 1.5);
  for (std::size_t b = 0; b < flow.y.size(); ++b) {
    double const h = std::abs(flow.y[b] - L / 2) - share * L / 2;  // beyond the edge of the band
    if (std::abs(h) < 2) continue;
    EXPECT_NEAR(flow.value[b], h < 0 ? fast_rate : slow_rate, 1e-12) << flow.y[b];
    EXPECT_NEAR(phi.value[b], h < 0 ? dense / 2 : dense, 1e-12) << phi.y[b];
  }
  auto const value = [&](char const* name) { return *results.scalars.at(name).all.mean; };
  EXPECT_NEAR(value("band_fraction_phi"), share, 1.0 / 40);
  EXPECT_NEAR(value("band_fraction_gammadot"), share, 1.0 / 40);
  EXPECT_NEAR(value("band_phi_fast"), dense / 2, 1e-12);
  EXPECT_NEAR(value("band_phi_slow"), dense, 1e-12);
  EXPECT_NEAR(value("band_gammadot_fast"), fast_rate, 1e-12);
  EXPECT_NEAR(value("band_gammadot_slow"), slow_rate, 1e-12);
}

TEST(Profiles, FollowABandThatDrifts) {
  std::vector<State> states;
  for (int f = 0; f < 40; ++f) states.push_back(band_state(1.5 * f));
  auto const results = profiles_of(states);
  auto const& moving = test::named(results.profiles, "gammadot");
  auto const& aligned = test::named(results.profiles, "gammadot_aligned");
  for (std::size_t b = 0; b < moving.y.size(); ++b) {
    EXPECT_NEAR(moving.value[b], rate, 1e-6) << "all that a band leaves that was everywhere";
    double const h = std::abs(aligned.y[b] - L / 2) - share * L / 2;
    if (std::abs(h) < 3) continue;
    EXPECT_NEAR(aligned.value[b], h < 0 ? fast_rate : slow_rate, 1e-5);
  }
  EXPECT_NEAR(*results.scalars.at("band_fraction_phi").all.mean, share, 0.03);
  EXPECT_NEAR(*results.scalars.at("band_fraction_gammadot").all.mean, share, 0.03);
  auto const& place = test::named(results.samples, "band_position").rows;
  for (int f = 0; f < 40; ++f)
    EXPECT_NEAR(test::around(place[static_cast<std::size_t>(2 * f + 1)], 1.5 * f, L), 0.0, 0.4);
}

TEST(Profiles, KineticStressIsAboutTheLocalFlow) {
  double const agitation = 1e-4;  // below v_x of the band itself, which is no heat
  auto const results = profiles_of({band_state(L / 2, agitation)});
  auto const& p_kin = test::named(results.profiles, "p_kin");
  auto const& phi = test::named(results.profiles, "phi");
  for (std::size_t b = 0; b < p_kin.y.size(); ++b) {
    if (std::abs(std::abs(p_kin.y[b] - L / 2) - share * L / 2) < 2) continue;  // the band's edges
    double const disks_per_area = phi.value[b] / (std::numbers::pi / 4);
    EXPECT_NEAR(p_kin.value[b], disks_per_area * agitation * agitation / 2, 1e-14);
    EXPECT_NEAR(test::named(results.profiles, "T_g").value[b], agitation * agitation / 2, 1e-14);
  }
}

TEST(Profiles, GoOnFromWhatWasSaved) {
  Scene const scene = test::plain_scene("CD", rate);
  Profiles straight(scene, Slices(L, L)), first(scene, Slices(L, L)), second(scene, Slices(L, L));
  ObserverState numbers;
  for (int f = 0; f < 12; ++f) {
    State const state = band_state(0.7 * f, 1e-4 * f);
    Frame const frame{state, f, 0.1 * f};
    straight.add(frame);
    (f < 5 ? first : second).add(frame);
    if (f == 4) {
      first.save(numbers);
      second.load(numbers);
    }
  }
  FrameResults one, two;
  straight.report({&straight}, one);
  second.report({&second}, two);
  ASSERT_EQ(one.profiles.size(), two.profiles.size());
  for (std::size_t k = 0; k < one.profiles.size(); ++k)
    EXPECT_EQ(one.profiles[k].value, two.profiles[k].value) << one.profiles[k].name;
  EXPECT_EQ(one.samples[0].rows, two.samples[0].rows);
}

}  // namespace
}  // namespace bagnold
