// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/lookahead_gain.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace bagnold {
namespace {

constexpr Real one_by_one = 16;  // cycles a disk-step

/// Lookaheads of 16 steps at a price a disk-step, till they are given up; how many they were.
int lookaheads_until_left(LookaheadGain& pay, Real contacts, Real price, int most = 10000) {
  for (int k = 1; k <= most; ++k)
    if (!pay.lookahead_done(16, contacts, 16 * price, 16 * one_by_one)) return k;
  return most + 1;
}

TEST(LookaheadGain, AreTriedOnceContactsAreFewInTheMean) {
  LookaheadGain pay;
  for (int k = 0; k < 20; ++k) pay.steps_done(256, 0.5);
  pay.steps_done(256, 0);  // a fluctuation
  EXPECT_FALSE(pay.enter());
  int looks = 1;
  for (; !pay.enter(); ++looks) pay.steps_done(256, 0.1);
  EXPECT_NEAR(looks * 256, 2048, 1024);
}

TEST(LookaheadGain, GoOnThroughDearOnesThatOthersMakeUpFor) {
  LookaheadGain pay;
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(lookaheads_until_left(pay, 0.2, 2 * one_by_one, 50), 51) << k;  // loses 12800
    EXPECT_EQ(lookaheads_until_left(pay, 0.2, one_by_one / 2, 150), 151) << k;
  }
}

TEST(LookaheadGain, AreGivenUpAfterTheLossOfAThousandSteps) {
  LookaheadGain pay;
  int const windows = lookaheads_until_left(pay, 0.2, 2 * one_by_one);
  EXPECT_NEAR(windows * 16, 1024, 16);
}

/// A trial of four lookaheads of twice the length does not end them.
TEST(LookaheadGain, BearATrialOfLongOnes) {
  LookaheadGain pay;
  for (int k = 0; k < 4; ++k)
    EXPECT_TRUE(pay.lookahead_done(16384, 0.01, 16384 * 2.5 * one_by_one, 16384 * one_by_one));
  EXPECT_TRUE(pay.lookahead_done(8192, 0.01, 8192 * 0.5 * one_by_one, 8192 * one_by_one));
}

/// Also where nothing touches at all.
TEST(LookaheadGain, AreNeverLockedOut) {
  LookaheadGain pay;
  while (pay.lookahead_done(16384, 0, 16384 * 2 * one_by_one, 16384 * one_by_one)) {
  }
  EXPECT_TRUE(pay.enter());
}

/// In a burst of contacts lookaheads that had paid are left; once it is over they are entered
/// again.
TEST(LookaheadGain, AreEnteredAgainAfterABurst) {
  LookaheadGain pay;
  EXPECT_EQ(lookaheads_until_left(pay, 0.2, one_by_one / 2, 5000), 5001);
  EXPECT_LT(lookaheads_until_left(pay, 0.5, 3 * one_by_one), 5000);
  pay.steps_done(256, 0.5);
  EXPECT_FALSE(pay.enter());
  for (int k = 0; k < 16; ++k) pay.steps_done(256, 0.2);
  EXPECT_TRUE(pay.enter());
}

/// Where they did not pay they are tried again only with fewer contacts.
TEST(LookaheadGain, AreTriedLessAndLessWhereTheyDoNotPay) {
  LookaheadGain pay;
  auto const enters = [&](Real contacts) {
    for (int k = 0; k < 64; ++k) pay.steps_done(256, contacts);
    return pay.enter();
  };
  for (Real const contacts : {0.2, 0.15, 0.11, 0.08}) {
    ASSERT_TRUE(enters(contacts)) << contacts;
    ASSERT_LT(lookaheads_until_left(pay, contacts, 2 * one_by_one), 100);
    EXPECT_FALSE(enters(contacts)) << contacts;
    EXPECT_FALSE(enters(0.9 * contacts)) << contacts;
  }
  EXPECT_TRUE(enters(0.06));
  lookaheads_until_left(pay, 0.2, 2 * one_by_one);  // with a burst, but they had not paid before it
  EXPECT_FALSE(enters(0.06));
}

TEST(LookaheadGain, GoesOnFromItsMemory) {
  LookaheadGain straight;
  int left = 0;
  for (int k = 0; k < 20000; ++k) {
    LookaheadGain copy;
    std::map<std::string, double> memory;
    straight.for_each_memory([&](char const* name, auto& value) { memory[name] = value; });
    copy.for_each_memory([&](char const* name, auto& value) { value = memory.at(name); });
    auto const goes_on = [k](LookaheadGain& pay) {
      return pay.lookahead_done(16, 0.2 + 0.1 * (k % 7), 16.0 * (k / 1000 % 2 == 0 ? 10 : 30),
                                16 * one_by_one);
    };
    bool const straight_on = goes_on(straight);
    ASSERT_EQ(goes_on(copy), straight_on);
    ASSERT_EQ(copy.enter(), straight.enter());
    left += !straight_on;
  }
  EXPECT_GT(left, 10);
}

}  // namespace
}  // namespace bagnold
