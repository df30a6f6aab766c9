// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/replica_scheduler.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace bagnold {
namespace {

using namespace std::chrono_literals;
using Request = ReplicaScheduler::Request;

/// Systems that count to `most`, a millisecond a count, and see that nobody else counts on them.
struct Counters {
  Counters(std::size_t systems, int threads, int most) : count(systems), user(systems) {
    work.systems = systems;
    work.threads = threads;
    work.turn = 5ms;
    work.advance = [this, most](std::size_t s, std::function<bool()> const& go_on) {
      EXPECT_EQ(++user[s], 1) << "two threads at one system";
      ++busy;
      bool more = true;
      while (more && count[s] < most) {
        std::this_thread::sleep_for(1ms);
        ++count[s];
        more = go_on();
      }
      --busy;
      --user[s];
      return count[s] == most;
    };
  }

  std::vector<int> counts() const { return {count.begin(), count.end()}; }

  ReplicaScheduler work;
  std::vector<std::atomic<int>> count;
  std::vector<std::atomic<int>> user;
  std::atomic<int> busy = 0;
};

class ReplicaSchedulerOn : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, ReplicaSchedulerOn, testing::Values(1, 2, 5));

TEST_P(ReplicaSchedulerOn, AllAreDone) {
  for (std::size_t const systems : {1u, 2u, 5u, 7u}) {
    Counters counters(systems, GetParam(), 20);
    EXPECT_TRUE(run(counters.work));
    EXPECT_EQ(counters.counts(), std::vector<int>(systems, 20));
  }
}

TEST_P(ReplicaSchedulerOn, NothingIsDoneForNoSystems) {
  Counters counters(0, GetParam(), 20);
  EXPECT_TRUE(run(counters.work));
}

/// One thread each; with one thread the caller's, which may be the only one a backend knows.
TEST_P(ReplicaSchedulerOn, OneThreadIsTheCallers) {
  Counters counters(3, GetParam(), 3);
  auto const mine = std::this_thread::get_id();
  auto const advance = counters.work.advance;
  std::atomic<int> at_home = 0, all = 0;
  counters.work.advance = [&](std::size_t s, std::function<bool()> const& go_on) {
    at_home += std::this_thread::get_id() == mine;
    ++all;
    return advance(s, go_on);
  };
  run(counters.work);
  EXPECT_EQ(at_home, GetParam() == 1 ? all.load() : 0);
}

TEST_P(ReplicaSchedulerOn, NobodyWorksWhileHeld) {
  Counters counters(4, GetParam(), 100);
  int held = 0;
  counters.work.request = [] { return Request::hold; };
  counters.work.held = [&] {
    ++held;
    // with one thread the system that asked is in the middle of its turn, between two steps
    int const mine = GetParam() == 1;
    EXPECT_EQ(counters.busy, mine);
    auto const before = counters.counts();
    std::this_thread::sleep_for(3ms);
    EXPECT_EQ(counters.counts(), before);
  };
  EXPECT_TRUE(run(counters.work));
  EXPECT_GE(held, 1);
  EXPECT_EQ(counters.counts(), std::vector<int>(4, 100));
}

TEST_P(ReplicaSchedulerOn, AStopLeavesTheRestUndone) {
  Counters counters(4, GetParam(), 100000);
  auto const begun = std::chrono::steady_clock::now();
  counters.work.request = [&] {
    return std::chrono::steady_clock::now() - begun > 30ms ? Request::stop : Request::go_on;
  };
  EXPECT_FALSE(run(counters.work));
  auto const left = counters.counts();
  EXPECT_EQ(counters.busy, 0);
  std::this_thread::sleep_for(5ms);
  EXPECT_EQ(counters.counts(), left) << "a thread still works";
}

/// With turns, no system is far behind however few the threads.
TEST_P(ReplicaSchedulerOn, AllGetOnAlike) {
  Counters counters(6, GetParam(), 100000);
  counters.work.request = [&] {
    auto const counts = counters.counts();
    return std::accumulate(counts.begin(), counts.end(), 0) > 600 ? Request::stop : Request::go_on;
  };
  EXPECT_FALSE(run(counters.work));
  for (int const count : counters.counts()) EXPECT_GT(count, 30);
}

TEST_P(ReplicaSchedulerOn, WhatOneThrowsEndsAll) {
  Counters counters(4, GetParam(), 100000);
  auto const advance = counters.work.advance;
  counters.work.advance = [&](std::size_t s, std::function<bool()> const& go_on) {
    if (s != 2) return advance(s, go_on);
    std::this_thread::sleep_for(5ms);
    throw std::runtime_error("two");
  };
  try {
    run(counters.work);
    FAIL();
  } catch (std::runtime_error const& error) {
    EXPECT_STREQ(error.what(), "two");
  }
  EXPECT_EQ(counters.busy, 0);
}

TEST_P(ReplicaSchedulerOn, WhatIsThrownWhileHeldEndsAll) {
  Counters counters(4, GetParam(), 100000);
  counters.work.request = [] { return Request::hold; };
  counters.work.held = [] { throw std::runtime_error("disk full"); };
  EXPECT_THROW(run(counters.work), std::runtime_error);
}

}  // namespace
}  // namespace bagnold
