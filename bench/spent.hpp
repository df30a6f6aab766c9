// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

#include <chrono>

namespace bagnold::bench {

/// Time that has gone by, [s].
struct Spent {
  double user;  ///< of all threads of this process, outside the kernel
  double wall;

  friend Spent operator-(Spent a, Spent b) { return {a.user - b.user, a.wall - b.wall}; }
};

/// Since some moment in the past. On a machine shared with others `user` is the steadier.
inline Spent spent_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::chrono::duration<double> const wall = std::chrono::steady_clock::now().time_since_epoch();
  return {static_cast<double>(usage.ru_utime.tv_sec) +
              1e-6 * static_cast<double>(usage.ru_utime.tv_usec),
          wall.count()};
}

}  // namespace bagnold::bench
