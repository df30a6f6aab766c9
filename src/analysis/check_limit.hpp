// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "src/analysis/rate_limit.hpp"
#include "src/config/scene.hpp"
#include "src/sweep/run_sweep.hpp"

namespace bagnold::analysis {

/// A scene to be tested for its limit.
struct LimitRequest {
  std::filesystem::path scene_file;  ///< names it in messages; start.file is sought beside it
  double tolerance = 0.05;           ///< relative change that counts as none
  bool allow_unstable = false;       ///< accept a time step beyond the scheme's stability
  std::string options;               ///< of the command that asks, for messages
  sweep::SweepOptions runs;          ///< of the two runs
};

/// Comparison of a scene at its strain rate and at half of it, and the limits that it supports.
struct LimitCheck {
  sweep::SweepEnd runs;  ///< the rest is there only where both are done
  double strain_rate = 0;
  std::map<std::string, AtTwoRates> measured;  ///< B_p, B_sigma, eta_p, eta_sigma, p, sigma
  RateLimit found;
};

/// Runs a scene of protocol "steady" at its strain rate and at half of it, as a sweep in a folder
/// that continues where it stopped. Compares the two (src/analysis/rate_limit.hpp) and writes
/// check_limit.json into the folder. Throws InputError for another protocol, and as sweep::run()
/// does; FileError where a result is damaged.
LimitCheck check_limit(Scene const& scene, std::filesystem::path const& folder,
                       LimitRequest const& request);

}  // namespace bagnold::analysis
