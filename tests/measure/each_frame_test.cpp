// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/each_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "src/measure/fields.hpp"
#include "src/measure/profiles.hpp"
#include "src/measure/rotation.hpp"
#include "tests/measure/states.hpp"

namespace bagnold {
namespace {

constexpr int side = 10;
constexpr std::int64_t window_steps = 10;

/// A rate for each frame.
State frame_state(int frame) {
  double const rate = 1e-3 * (1 + frame);
  State state = test::square_lattice(side, 1.3, rate);
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const k = static_cast<double>(i) + 0.1 * frame;
    state.velocity[i][0] += rate * std::sin(3.1 * k);
    state.velocity[i][1] += rate * std::cos(1.7 * k);
  }
  state.spin.assign(state.count(), -0.3 * rate * frame);
  return state;
}

/// Four windows up, four down.
Plan up_and_down() {
  Ramp ramp;
  ramp.time_step = 0.1;
  ramp.lowest = 1e-3;
  ramp.growth = 0.1;
  ramp.piece_steps = ramp.window_steps = window_steps;
  ramp.leg_pieces = 4;
  ramp.legs = 2;
  Plan plan;
  plan.ramp = ramp;
  plan.time_step = ramp.time_step;
  plan.steps = ramp.steps();
  plan.window_steps = window_steps;
  return plan;
}

std::unique_ptr<FrameObserver> observer_of(std::string const& kind) {
  if (kind == "rotation") return std::make_unique<Rotation>();
  if (kind == "fields") return std::make_unique<Fields>();
  return std::make_unique<Profiles>(test::plain_scene("CD_rot", 1e-3),
                                    Slices(side * 1.3, side * 1.3));
}

EachFrame fresh(std::string const& kind) { return {kind, observer_of(kind), up_and_down()}; }

void show(FrameObserver& to, int frame, double strain) {
  State const state = frame_state(frame);
  to.add({state, frame * window_steps, strain});
}

/// What the observer finds that is shown one frame alone.
FrameResults found_on(std::string const& kind, int frame) {
  auto const observer = observer_of(kind);
  show(*observer, frame, 0);
  FrameResults found;
  observer->report({observer.get()}, found);
  return found;
}

void expect_equal(double a, double b, std::string const& what) {
  if (std::isnan(b))
    EXPECT_TRUE(std::isnan(a)) << what;
  else
    EXPECT_EQ(a, b) << what;
}

/// Row `row` of frame-wise values is `expected`.
void expect_row(std::vector<double> const& values, std::size_t row,
                std::vector<double> const& expected, std::string const& what) {
  ASSERT_GE(values.size(), (row + 1) * expected.size()) << what;
  for (std::size_t k = 0; k < expected.size(); ++k)
    expect_equal(values[row * expected.size() + k], expected[k], what);
}

TEST(EachFrame, FindsWhatItsObserverFindsOnThatFrameAlone) {
  for (std::string const kind : {"rotation", "fields", "profiles"}) {
    auto all = fresh(kind);
    for (int frame = 0; frame < 3; ++frame) {
      show(all, 2 * frame, 0.1 * frame);
      ObserverState saved;  // and goes on from what is saved
      all.save(saved);
      auto again = fresh(kind);
      again.load(saved);
      all = std::move(again);
    }
    FrameResults found;
    all.report({&all}, found);
    ASSERT_FALSE(found.histograms.empty() && found.profiles.empty());
    for (std::size_t row = 0; row < 3; ++row) {
      auto const expected = found_on(kind, 2 * static_cast<int>(row));
      ASSERT_EQ(found.histograms.size(), expected.histograms.size());
      for (auto const& one : expected.histograms) {
        auto const& rows = test::named(found.histograms, one.name);
        EXPECT_EQ(rows.edges, one.edges);
        EXPECT_EQ(rows.frames, std::vector<std::size_t>{3});
        expect_row(rows.density, row, one.density, one.name);
      }
      ASSERT_EQ(found.profiles.size(), expected.profiles.size());
      for (auto const& one : expected.profiles) {
        auto const& rows = test::named(found.profiles, one.name);
        EXPECT_EQ(rows.y, one.y);
        EXPECT_EQ(rows.frames, std::vector<std::size_t>{3});
        expect_row(rows.value, row, one.value, one.name);
      }
    }
    EXPECT_EQ(test::named(found.samples, "ramp_frames").rows,
              (std::vector<double>{0.0, 1e-3, 1, 0.1, 3e-3, 1, 0.2, 5e-3, -1}));
  }
}

TEST(EachFrame, OfSeveralSystemsHasAnAxisForThem) {
  auto first = fresh("rotation"), second = fresh("rotation");
  for (int frame = 0; frame < 3; ++frame) show(first, frame, 0.1 * frame);
  for (int frame = 4; frame < 6; ++frame) show(second, frame, 0.1 * frame);  // has seen fewer
  FrameResults found;
  first.report({&first, &second}, found);
  auto const& rows = test::named(found.histograms, "rotation");
  EXPECT_EQ(rows.frames, (std::vector<std::size_t>{2, 2}));
  for (std::size_t row = 0; row < 4; ++row) {
    int const frame = static_cast<int>(row < 2 ? row : row + 2);
    expect_row(rows.density, row, found_on("rotation", frame).histograms.front().density, "");
  }
  EXPECT_EQ(test::named(found.samples, "ramp_frames").rows.size(), 2u * 3);
}

TEST(EachFrame, ReportsNothingBeforeTheFirstFrame) {
  auto const none = fresh("profiles");
  FrameResults found;
  none.report({&none}, found);
  EXPECT_TRUE(found.profiles.empty() && found.samples.empty());
}

}  // namespace
}  // namespace bagnold
