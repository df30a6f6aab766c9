// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "src/statistics/replicas.hpp"

/// Criterion to end a run whose errors are small enough.
///
/// Errors that scatter are sometimes small by chance, and those of a skewed quantity are small
/// where its mean is low. A run that ends at the first small error states half the true one. A run
/// therefore ends if, at two checks in a row, a factor of 1.5 apart,
///
/// 1. each replica has 32 independent windows, and an error that is not rough;
///
/// 2. the cautious() error meets the target.
///
/// The second check has half as many windows again, which are independent of the fluctuation that
/// passed the first. In synthetic series (tests/statistics/stopping_test.cpp) and simulated ones
/// (docs/statistics.md) means are then off by more than two stated errors in less than 7% of runs,
/// and biased by less than a quarter of an error. Runs end at about half (four replicas) to two
/// thirds (one) of the requested error.
namespace bagnold::statistics {

/// Windows, first discarded ones included, at the first check.
inline constexpr std::int64_t first_look = 100;

/// Ratio of the windows of a check to those of the check before.
inline constexpr double look_factor = 1.5;

/// Fewest independent windows of each replica, n / (2 tau_int).
inline constexpr double fewest_independent = 32;

/// First number of windows, from `windows` on, at which errors are checked: 100, and each time half
/// as many again, rounded up; at last `most`. It depends on no clock.
std::int64_t next_look(std::int64_t windows, std::int64_t most);

/// Check before the one at `windows`; 0 if there is none.
std::int64_t look_before(std::int64_t windows);

/// True if each replica has run long enough to be judged by its errors.
bool long_enough(ReplicaEstimate const& found);

/// found.all with an error that is as rarely small by chance as possible: the larger one of
///
/// - the combined errors of the replicas, as for R = 2 (replicas.hpp), if each has one;
///
/// - from R = 3 on the jackknife over replicas;
///
/// both multiplied by Student's factor (student.hpp), of their blocks less one each and of R - 1,
/// unless they contain it already, being rough.
Estimate cautious(ReplicaEstimate const& found);

/// True if a run of `windows` windows may end: `met` is true for the windows of this check and of
/// the check before.
bool met_twice(std::int64_t windows, std::function<bool(std::int64_t)> const& met);

}  // namespace bagnold::statistics
