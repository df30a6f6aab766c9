// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

namespace bagnold::bench {

/// Time that has gone by, [s].
struct Spent {
  double cpu;  ///< of all threads of this process
  double wall;

  friend Spent operator-(Spent a, Spent b) { return {a.cpu - b.cpu, a.wall - b.wall}; }
};

/// Since some moment in the past. On a machine shared with others `cpu` is the steadier. Not
/// getrusage: how it divides this time into user's and system's is a guess from ticks.
inline Spent spent_so_far() {
  auto const seconds = [](clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  return {seconds(CLOCK_PROCESS_CPUTIME_ID), seconds(CLOCK_MONOTONIC)};
}

}  // namespace bagnold::bench
