// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "src/measure/fields.hpp"
#include "src/measure/profiles.hpp"
#include "src/measure/rotation.hpp"
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

/// Two systems of six frames each, joined, are as one of twelve.
template <class Observer>
void expect_joined(Observer whole, Observer first, Observer second, Observer joined) {
  for (int f = 0; f < 12; ++f) {
    State const state = frame_state(f);
    Frame const frame{state, f, 0.1 * f};
    whole.add(frame);
    (f < 6 ? first : second).add(frame);
  }
  joined.join(first);
  joined.join(second);
  FrameResults one, two;
  whole.report(one);
  joined.report(two);
  ASSERT_EQ(one.histograms.size(), two.histograms.size());
  for (std::size_t k = 0; k < one.histograms.size(); ++k)
    EXPECT_EQ(one.histograms[k].density, two.histograms[k].density);
  ASSERT_EQ(one.profiles.size(), two.profiles.size());
  for (std::size_t k = 0; k < one.profiles.size(); ++k)
    EXPECT_EQ(one.profiles[k].value, two.profiles[k].value) << one.profiles[k].name;
  for (std::size_t k = 0; k < one.scalars.size(); ++k)
    EXPECT_EQ(one.scalars[k].estimate.mean, two.scalars[k].estimate.mean) << one.scalars[k].name;
}

TEST(Join, OfSystemsSideBySide) {
  Scene const scene = test::plain_scene("CD_rot", rate);
  Profiles const profiles(scene, 12 * 1.3);
  expect_joined(profiles, profiles, profiles, profiles);
  Fields const fields(scene);
  expect_joined(fields, fields, fields, fields);
  expect_joined(Rotation(), Rotation(), Rotation(), Rotation());
}

}  // namespace
}  // namespace bagnold
