// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/unwrapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bagnold {
namespace {

constexpr double length = 8.0, height = 10.0, strain_a_frame = 0.35;

/// Disks that diffuse in a shear flow: where they are, and the state that a frame holds of it.
class Walk {
 public:
  explicit Walk(std::size_t count) : place(count) {
    for (auto& [x, y] : place) {
      x = length * std::abs(step_(random_)) / 4;
      y = height * std::abs(step_(random_)) / 4;
    }
  }

  void go() {
    for (auto& [x, y] : place) {
      double const up = step_(random_);
      x += step_(random_) + strain_a_frame * (y + up / 2);
      y += up;
    }
    strain += strain_a_frame;
  }

  /// Every disk at its image in the box.
  State state() const {
    State state;
    state.box_length = length;
    state.box_aspect = height / length;
    state.offset = std::fmod(strain * height, length);
    for (auto const& [x, y] : place) {
      double const row = std::floor(y / height);
      double const below = x - row * strain * height;
      state.position.push_back({below - length * std::floor(below / length), y - row * height});
    }
    return state;
  }

  std::vector<std::array<double, 2>> place;
  double strain = 0;

 private:
  std::mt19937 random_{3};
  std::normal_distribution<double> step_{0.0, 0.7};
};

/// Places by images less the places themselves: a cell vector a disk, the same in all frames.
void expect_followed(Walk const& walk, State const& state, io::Images const& images,
                     std::vector<std::array<double, 2>> const& first) {
  for (std::size_t i = 0; i < images.size(); ++i) {
    auto const [columns, rows] = images[i];
    double const x = state.position[i][0] + columns * length + rows * io::tilt_of(state);
    double const y = state.position[i][1] + rows * height;
    // a row above the place itself, a disk has gone further by gamma height
    double const row = std::round(first[i][1] / height);
    EXPECT_NEAR(y - walk.place[i][1], first[i][1], 1e-9);
    EXPECT_NEAR(x - walk.place[i][0], first[i][0] + row * walk.strain * height, 1e-8);
  }
}

TEST(Unwrapping, FollowsDisksThroughTheBoundaries) {
  Walk walk(40);
  Unwrapping unwrapping;
  std::vector<std::array<double, 2>> first;
  double farthest = 0;
  for (int frame = 0; frame < 300; ++frame) {
    State const state = walk.state();
    auto const images = unwrapping.next(state, walk.strain);
    if (frame == 0)
      for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(images[i][0], 0);
        EXPECT_EQ(images[i][1], 0);
        first.push_back(
            {state.position[i][0] - walk.place[i][0], state.position[i][1] - walk.place[i][1]});
      }
    expect_followed(walk, state, images, first);
    for (auto const& [x, y] : walk.place) farthest = std::max(farthest, std::abs(y));
    walk.go();
  }
  EXPECT_GT(farthest, 2 * height);
}

TEST(Unwrapping, GoesOnAsIfItHadNotStopped) {
  Walk walk(20);
  Unwrapping whole;
  for (int frame = 0; frame < 30; ++frame, walk.go()) {
    State const state = walk.state();
    auto const images = whole.next(state, walk.strain);
    Unwrapping resumed;
    resumed.go_on_from(state, walk.strain, images);
    Walk next = walk;
    next.go();
    Unwrapping copy = whole;
    EXPECT_EQ(resumed.next(next.state(), next.strain), copy.next(next.state(), next.strain));
  }
}

}  // namespace
}  // namespace bagnold
