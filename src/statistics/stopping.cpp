// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/stopping.hpp"

#include <algorithm>

#include "src/statistics/student.hpp"

namespace bagnold::statistics {
namespace {

std::int64_t look_after(std::int64_t windows) { return windows + (windows + 1) / 2; }

}  // namespace

std::int64_t next_look(std::int64_t windows, std::int64_t most) {
  std::int64_t look = first_look;
  while (look < windows) look = look_after(look);
  return std::min(look, most);
}

std::int64_t look_before(std::int64_t windows) {
  std::int64_t before = 0;
  for (std::int64_t look = first_look; look < windows; look = look_after(look)) before = look;
  return before;
}

bool long_enough(ReplicaEstimate const& found) {
  return std::ranges::all_of(found.each, [](Estimate const& one) {
    return one.error && !one.rough && one.independent >= fewest_independent;
  });
}

Estimate cautious(ReplicaEstimate const& found) {
  Estimate all = found.all;
  auto const replicas = found.each.size();
  if (!all.error) return all;
  double error = 0.0;
  if (replicas >= fewest_replicas) error = *all.error * student_factor(replicas - 1);
  if (auto const& within = found.within; within.error)
    error = std::max(
        error, *within.error * (within.rough ? 1.0 : student_factor(within.blocks - replicas)));
  all.error = error;
  return all;
}

bool met_twice(std::int64_t windows, std::function<bool(std::int64_t)> const& met) {
  auto const before = look_before(windows);
  return before > 0 && met(windows) && met(before);
}

}  // namespace bagnold::statistics
