// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "src/statistics/replicas.hpp"

/// When a run may end because its errors are small enough.
///
/// Errors that scatter are now and then small by luck, and of a skewed quantity they are small
/// where its mean is low: a run that ends at the first small error states half the true one. So a
/// run ends where, at two looks in a row, a factor of 1.5 apart,
///
/// 1. each replica is worth 32 independent windows, and has an error that is not rough;
/// 2. the cautious() error meets the target.
///
/// The second look has half as many windows again, which no luck of the first has chosen. Made
/// series (tests/statistics/stopping_test.cpp) and simulated ones (docs/statistics.md) then end
/// with means that are off by more than two stated errors in less than 7% of runs, and biased by
/// less than a quarter of one. They end at about half (four replicas) to two thirds (one) of the
/// error that was asked for.
namespace bagnold::statistics {

/// Windows, first discarded ones included, at the first look.
inline constexpr std::int64_t first_look = 100;

/// Windows of a look over those of the look before.
inline constexpr double look_factor = 1.5;

/// Fewest independent windows of each replica, n / (2 tau_int).
inline constexpr double fewest_independent = 32;

/// The first number of windows at which errors are looked at from `windows` on: 100, and each time
/// half as many again, rounded up; `most` at last. What a run does depends on no clock.
std::int64_t next_look(std::int64_t windows, std::int64_t most);

/// The look before one at `windows`; 0 where there is none.
std::int64_t look_before(std::int64_t windows);

/// Whether each replica has run for long enough to be judged by its errors.
bool long_enough(ReplicaEstimate const& found);

/// found.all with an error that luck makes small as seldom as can be: the larger one of
///
/// - what the replicas' own errors add up to, as for R = 2 (replicas.hpp), where each has one;
/// - from R = 3 on the jackknife over replicas;
///
/// both times Student's factor (student.hpp), of their blocks less one each and of R - 1, where
/// they do not have it yet, being rough.
Estimate cautious(ReplicaEstimate const& found);

/// Whether a run of `windows` windows may end: `met`, asked for the windows of a look, is true of
/// this one and of the look before.
bool met_twice(std::int64_t windows, std::function<bool(std::int64_t)> const& met);

}  // namespace bagnold::statistics
