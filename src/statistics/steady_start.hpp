// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

namespace bagnold::statistics {

/// Beginning of the steady part of a series.
struct SteadyStart {
  std::size_t first = 0;  ///< values before it belong to the transient
  bool found = false;  ///< false: no minimum before the middle; `first` is the middle, rounded up
};

/// MSER-5: K. P. White Jr., Simulation 69, 323 (1997); White, Cobb and Spratt, Proc. Winter
/// Simulation Conf. 755 (2000). With z_j the means of m batches of 5 values,
///
///     d* = argmin_d (1/(m - d)^2) sum_{j > d} (z_j - mean_{j > d})^2,   d <= m/2,
///
/// the truncation with the smallest (marginal) standard error of the rest: more of a transient
/// increases the scatter, less of a series decreases the number of values. A minimum at the limit
/// m/2 does not count: the transient is not over, the series is too short.
///
/// It cuts where the transient is as large as the noise of a batch. The rest of the transient
/// biases the mean: at n = 4000 and 20 standard deviations at the start by 0.1 to 0.3 standard
/// errors if it decays exponentially (in 50 values), by 0.3 to 0.8 if it decays as t^-2 (from 20
/// on). Of a stationary series 1 to 2% is lost on average (first-order autoregressive noise, n at
/// least 100 correlation times), over a quarter in 1% of cases at most. Fewer than 10 values: not
/// found.
SteadyStart steady_start(std::span<double const> series);

}  // namespace bagnold::statistics
