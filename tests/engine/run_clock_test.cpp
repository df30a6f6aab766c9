// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/run_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bagnold {
namespace {

Ramp steep_ramp() {
  Ramp ramp;
  ramp.time_step = 0.2;
  ramp.lowest = 1e-4;
  ramp.growth = 0.013;
  ramp.fast_steps = 30;
  ramp.slow_steps = 60;
  ramp.piece_steps = 5;
  ramp.leg_pieces = 300;
  ramp.legs = 4;
  ramp.window_steps = 30;
  return ramp;
}

RunClock clock_of(StrainRates const& rates, double aspect, std::int64_t step = 0) {
  Snapshot snapshot;
  snapshot.state.box_length = 38.6;
  snapshot.state.box_aspect = aspect;
  snapshot.initial_offset = 12.3;
  snapshot.initial_time = 7;
  snapshot.step = step;
  return {rates, 0.2, snapshot};
}

TEST(RunClock, OfOneRateIsAPlainClock) {
  auto const clock = clock_of(1e-3, 2.0, 77);
  Clock const plain{1e-3, 0.2, 38.6, 12.3, 7, 2.0};
  EXPECT_EQ(clock.rate_end, StrainRates::never);
  for (std::int64_t const step : {0, 1, 77, 123456789}) {
    EXPECT_EQ(clock.strain(step), plain.strain(step));
    EXPECT_EQ(clock.offset(step + 9, clock.mark(step)), plain.offset(step + 9, step));
    EXPECT_EQ(clock.strain_since(clock.mark(step), step + 9), plain.strain_between(step, step + 9));
  }
}

/// Strain and offset from marks far back, over many rates, at every step of a ramp.
TEST(RunClock, CountsTheStrainOfAllRates) {
  Ramp const ramp = steep_ramp();
  for (double const aspect : {1.0, 3.0}) {
    auto clock = clock_of(ramp, aspect);
    std::vector<ShearMark> marks;
    double factors = 1;
    int changes = 0;
    for (std::int64_t step = 0; step <= ramp.steps(); ++step) {
      if (step == clock.rate_end) {
        factors *= clock.change_rate().factor;
        ++changes;
      }
      auto const piece = ramp.piece(std::min(step, ramp.steps() - 1));
      ASSERT_EQ(clock.strain_rate, piece.rate);
      long double const strain = ramp.strain(step);
      ASSERT_NEAR(clock.strain(step), static_cast<double>(strain), 1e-15);
      if (step % 37 == 0) marks.push_back(clock.mark(step));
      for (auto const& mark : marks) {
        auto const since = static_cast<double>(strain - ramp.strain(mark.step));
        ASSERT_NEAR(clock.strain_since(mark, step), since, 1e-15);
        double const at_mark = clock.box(mark).offset;
        ASSERT_GE(at_mark, 0);
        ASSERT_LT(at_mark, 38.6);
        ASSERT_NEAR(clock.offset(step, mark), at_mark + since * aspect * 38.6, 1e-12);
      }
      // a mark is set anew, bit for bit, from its step
      auto const again = clock.at(marks.back().step).mark(marks.back().step);
      ASSERT_EQ(again.strain.rounded(), marks.back().strain.rounded());
      ASSERT_EQ(again.turns.high, marks.back().turns.high);
      ASSERT_EQ(again.turns.low, marks.back().turns.low);
    }
    EXPECT_EQ(changes, 1 + 4 * 300);
    EXPECT_NEAR(factors, clock.strain_rate / Ramp::fast_rate, 1e-12);
  }
}

}  // namespace
}  // namespace bagnold
