// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "src/analysis/fit/points.hpp"
#include "src/analysis/outcome.hpp"
#include "src/analysis/request.hpp"

namespace bagnold::analysis {

/// Kinks that no smooth branch makes: `kink --curved`, P2 Figs. 22 and 23.
///
/// A curve that one polynomial with as many parameters describes within chance has none. Else two
/// curves are fitted, with branches of the second degree, and of the third below the first kink,
/// where a branch rises ever more steeply towards it. Where chi2 is beyond chance each law is taken
/// to be off by a share of y at each point, as in fit_all. A kink stands if both curves have it,
/// three errors clear of no bend at all, bent the same way (that of `direction`, where one is asked
/// for), at places within two errors of each other. The place is that of the second degree, the
/// error holds the difference to that of the third.
class CurvedKinks {
 public:
  explicit CurvedKinks(Request const& request) : request_(request) {}

  /// Finds kinks, in the format of `kink` without curved branches: value = {x_1, y_1, ...}, NaN
  /// where a kink does not stand. Called for the measured points first; resampled points take their
  /// misfit from that call.
  FitResult operator()(Points const& measured, std::uint32_t replica) const;

 private:
  struct Known {
    double misfit = 0.0;
    std::vector<bool> stands;
  };
  Request request_;
  std::shared_ptr<Known> known_ = std::make_shared<Known>();
};

}  // namespace bagnold::analysis
