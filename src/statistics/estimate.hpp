// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "src/statistics/jackknife.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold::statistics {

/// A mean with its standard error, in the unit of the quantity. Unknown values are empty.
struct Estimate {
  std::optional<double> mean;         ///< f(averages); empty where f is undefined, as in 0/0
  std::optional<double> error;        ///< one standard deviation of the mean
  std::optional<double> correlation;  ///< tau_int, in windows; 1/2: windows are independent
  std::size_t samples = 0;            ///< windows measured
  double independent = 0;             ///< windows that would have this scatter were they so
  std::size_t blocks = 0;             ///< blocks the error comes from; 0: none
  bool rough = false;                 ///< an error from 4 to 7 blocks, with Student's factor
  std::string remark;  ///< why there is no error or a rough one, what to do; empty: all is well
};

/// Fewest blocks of an error that is not rough: from 8 it is itself uncertain by 1/sqrt(2 * 7), a
/// quarter. It takes n = 64 tau_int windows to have them.
inline constexpr std::size_t fewest_blocks = 8;

/// Fewest blocks of a rough error, uncertain by 1/sqrt(2 * 3): n = 23 tau_int.
inline constexpr std::size_t fewest_rough_blocks = 4;

/// f of the averages over all windows from `first` on (those before it are discarded), and its
/// error. It is never the mean of f over windows: a ratio of averages has no bias from noisy
/// windows.
///
/// 1. Leaving out one window at a time makes f, however it combines the averages, a series of one
/// value a window (jackknife.hpp).
///
/// 2. Blocking of that series gives a first correlation time, and that the length of the blocks
/// (blocking.hpp).
///
/// 3. The error is the jackknife over blocks of this length; tau_int = (1/2) (error / se_1)^2, se_1
/// being that of the series if its windows were independent.
///
/// 4. Both are corrected for the end effect of blocks, (1/4)(tau_int / n)^(1/3) of the error: 2.5%
/// at n = 1000 tau_int, 5% at 100.
///
/// On first-order autoregressive series errors are right on average within 2% above n = 150 tau_int
/// and about 4% low at 100 tau_int; each one scatters by (tau_int / n)^(1/3), 10% at 1000 tau_int.
/// With two time scales (0.3 and 0.95 a window) they were 7 to 9% low, with damped oscillations 6
/// to 9% high.
///
/// From 4 to 7 blocks the error is rough: it is multiplied by Student's factor (student.hpp), so
/// that mean +- 2 errors holds the truth with the nominal frequency: for autoregressive series in
/// 0.94 to 0.99 above n = 24 tau_int. With fewer than 4 blocks there is no error.
///
/// Far too short a run can still seem long enough (1% of runs of 4 tau_int, 10% of 20 tau_int; for
/// a rough error 3 to 13% of 8 tau_int, whose mean +- 2 errors holds the truth in 60 to 85%). No
/// method detects what has not happened yet: if a system changes between two states only a few
/// times, errors come out too small.
///
/// A quantity that does not change, to rounding, has error 0 and no correlation time. Costs n calls
/// of f and memory for a few times n numbers.
Estimate estimate(Windows const& windows, std::size_t first, Function const& f);

}  // namespace bagnold::statistics
