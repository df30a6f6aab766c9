// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/lookahead_tuning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace bagnold {
namespace {

/// Looking costs a/M, stepping b M; caution costs a tenth more or less.
Real cost(LookaheadTuning const& choice, Real best_steps, bool caution_pays) {
  Real const ratio = static_cast<Real>(choice.steps()) / best_steps;
  return (ratio + 1 / ratio) * (choice.cautious() == caution_pays ? 1.0 : 1.1);
}

TEST(LookaheadTuning, FindsTheCheapestFromAnywhere) {
  for (Real const best : {16.0, 64.0, 1024.0, 16384.0})
    for (bool const caution_pays : {false, true}) {
      LookaheadTuning choice;
      for (int k = 0; k < 2000; ++k) choice.done(cost(choice, best, caution_pays));
      std::map<std::pair<std::int64_t, bool>, int> done;
      for (int k = 0; k < 360; ++k) {
        ++done[{choice.steps(), choice.cautious()}];
        choice.done(cost(choice, best, caution_pays));
      }
      EXPECT_GE((done[{static_cast<std::int64_t>(best), caution_pays}]), 300) << best;
    }
}

TEST(LookaheadTuning, ARefusalMakesWindowsShorterUntilThereIsNone) {
  LookaheadTuning choice;
  for (std::int64_t const steps : {64, 32, 16, 16}) {
    EXPECT_EQ(choice.steps(), steps);
    EXPECT_EQ(choice.refused(), steps > 16);
  }
}

TEST(LookaheadTuning, GoesOnFromItsMemory) {
  LookaheadTuning straight;
  for (int k = 0; k < 777; ++k) {
    LookaheadTuning copy;
    std::map<std::string, double> memory;
    straight.for_each_memory(
        [&](char const* name, auto& value) { memory[name] = static_cast<double>(value); });
    copy.for_each_memory([&](char const* name, auto& value) {
      value = static_cast<std::decay_t<decltype(value)>>(memory.at(name));
    });
    ASSERT_EQ(copy.steps(), straight.steps());
    ASSERT_EQ(copy.cautious(), straight.cautious());
    copy.done(cost(copy, 512, true));
    straight.done(cost(straight, 512, true));
    ASSERT_EQ(copy.steps(), straight.steps());
  }
}

}  // namespace
}  // namespace bagnold
