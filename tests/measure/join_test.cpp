// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "src/measure/fields.hpp"
#include "src/measure/profiles.hpp"
#include "src/measure/rotation.hpp"
#include "tests/measure/seen.hpp"
#include "tests/measure/states.hpp"

namespace bagnold {
namespace {

constexpr double rate = 1e-3;

State frame_state(int frame) {
  State state = test::square_lattice(12, 1.3, rate);
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const k = static_cast<double>(i) + 0.1 * frame;
    state.velocity[i][0] += 1e-3 * std::sin(3.1 * k);
    state.velocity[i][1] += 1e-3 * std::cos(1.7 * k);
    state.position[i][1] = std::fmod(state.position[i][1] + 0.4 * frame, state.box_length);
  }
  state.spin.assign(state.count(), -0.5 * rate * frame);
  return state;
}

/// What two systems of six frames each found together, and one of all twelve.
template <class Observer>
std::pair<test::Seen, test::Seen> joined_and_whole(Observer const& fresh) {
  Observer whole = fresh, first = fresh, second = fresh;
  for (int f = 0; f < 12; ++f) {
    State const state = frame_state(f);
    Frame const frame{state, f, 0.1 * f};
    whole.add(frame);
    (f < 6 ? first : second).add(frame);
  }
  return {test::seen_by({&first, &second}), test::seen_by({&whole})};
}

TEST(Join, HistogramsCountAllFrames) {
  for (auto const& [joined, whole] : {joined_and_whole(Fields()), joined_and_whole(Rotation())}) {
    ASSERT_EQ(joined.histograms.size(), whole.histograms.size());
    for (std::size_t k = 0; k < whole.histograms.size(); ++k)
      EXPECT_EQ(joined.histograms[k].density, whole.histograms[k].density);
  }
}

TEST(Join, TheFirstSystemIsPictured) {
  auto const [joined, whole] = joined_and_whole(Fields());
  EXPECT_EQ(test::named(joined.samples, "fields_frame").rows[0], 5.0);
  EXPECT_EQ(test::named(whole.samples, "fields_frame").rows[0], 11.0);
}

TEST(Join, ProfilesAreOfTheAveragesOverAllFrames) {
  auto const [joined, whole] =
      joined_and_whole(Profiles(test::plain_scene("CD_rot", rate), Slices(12 * 1.3, 12 * 1.3)));
  ASSERT_EQ(joined.profiles.size(), whole.profiles.size());
  for (std::size_t k = 0; k < whole.profiles.size(); ++k)
    for (std::size_t b = 0; b < whole.profiles[k].value.size(); ++b) {
      double const expected = whole.profiles[k].value[b];
      EXPECT_NEAR(joined.profiles[k].value[b], expected, 1e-9 * std::abs(expected) + 1e-15)
          << whole.profiles[k].name;
    }
  EXPECT_EQ(whole.scalars.size(), 6u);
  for (auto const& [name, estimate] : whole.scalars)
    EXPECT_NEAR(*joined.scalars.at(name).all.mean, *estimate.all.mean, 1e-9);
  EXPECT_EQ(joined.samples[0].rows, whole.samples[0].rows);
}

/// phi is an average, so of R = 4 systems as long its error is that of the mean of four numbers.
TEST(Join, ErrorsAreThoseOfTheScatterOverSystems) {
  Profiles const fresh(test::plain_scene("CD_rot", rate), Slices(12 * 1.3, 12 * 1.3));
  std::vector<Profiles> systems(4, fresh);
  std::vector<FrameObserver const*> all;
  std::vector<test::Seen> alone(4);
  for (std::size_t r = 0; r < 4; ++r) {
    for (int f = 0; f < 3; ++f) {
      auto const frame = static_cast<int>(3 * r) + f;
      State const state = frame_state(frame * frame);
      systems[r].add({state, f, 0.1 * f});
    }
    alone[r] = test::seen_by({&systems[r]});
    all.push_back(&systems[r]);
  }
  auto const found = test::seen_by(all);
  auto const& phi = test::named(found.profiles, "phi");
  for (std::size_t b = 0; b < phi.value.size(); ++b) {
    double mean = 0.0, squares = 0.0;
    auto const of = [&](std::size_t r) { return test::named(alone[r].profiles, "phi").value[b]; };
    for (std::size_t r = 0; r < 4; ++r) mean += of(r) / 4;
    for (std::size_t r = 0; r < 4; ++r) squares += std::pow(of(r) - mean, 2);
    EXPECT_NEAR(phi.value[b], mean, 1e-13);
    ASSERT_GT(squares, 0.0);
    EXPECT_NEAR(phi.error[b] / std::sqrt(squares / (4 * 3)), 1.0, 1e-9);
  }
  auto const& share = found.scalars.at("band_fraction_phi");
  ASSERT_EQ(share.each.size(), 4u);
  for (std::size_t r = 0; r < 4; ++r)
    EXPECT_EQ(share.each[r].mean, alone[r].scalars.at("band_fraction_phi").all.mean);
  EXPECT_EQ(share.all.samples, 12u);
}

}  // namespace
}  // namespace bagnold
