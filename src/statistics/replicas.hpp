// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "src/statistics/estimate.hpp"

namespace bagnold::statistics {

/// A quantity over R independent systems, and for each alone.
struct ReplicaEstimate {
  Estimate all;
  std::vector<Estimate> each;  ///< [R]
  Estimate within;             ///< error, blocks, rough, remark: the combined errors of each, below
};

/// Fewest replicas whose scatter gives the error.
inline constexpr std::size_t fewest_replicas = 3;

/// f of the averages over all windows from `first` on of all replicas, and its error.
///
/// From R = 3 on the error is the jackknife that leaves out one replica at a time (jackknife.hpp, a
/// block being all windows of a replica):
///
///     error^2 = (R-1)/R sum_r (f_{-r} - mean)^2     for equal weights.
///
/// It does not depend on correlation times. It is therefore right for runs too short for an error
/// of their own, and if each replica is in a state that the others do not reach. Its own relative
/// uncertainty is 1/sqrt(2 (R - 1)), half of it at R = 3; `blocks` is R.
///
/// For R = 2, whose one difference says almost nothing, the errors of estimate() are combined:
/// error = [(M_1 e_1)^2 + (M_2 e_2)^2]^(1/2) / (M_1 + M_2), M the weights; rough if one of them is,
/// none if one has none. R = 1 is estimate(). Such a combination is `within` for every R. It comes
/// from many more blocks than there are replicas, but does not show whether the replicas are in one
/// state. The correlation time is the mean of those of the replicas that have one.
ReplicaEstimate estimate(std::vector<Windows const*> const& replicas, std::size_t first,
                         Function const& f);

/// Source of the error of estimate() for R replicas, in words.
std::string_view error_source(std::size_t replicas);

}  // namespace bagnold::statistics
