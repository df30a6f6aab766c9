// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/fit/fit.hpp"

namespace bagnold::analysis {

/// Options of an analysis as the user gave them. An empty name stands for the kind's own.
struct Request {
  std::string x, y;   ///< quantities on the axes (src/analysis/quantity.hpp)
  std::string along;  ///< key that runs along a curve; empty: x, or disks.packing_fraction
  std::vector<std::string> by;
  std::map<std::string, std::string> where;
  std::optional<std::pair<double, double>> range;  ///< of x
  std::size_t first = 0;                           ///< only so many points of smallest x; 0: all
  std::optional<double> phi_j;                     ///< fixes phi_J; needed by phi_J-phi
  Fixed fixed;                                     ///< other parameters
  bool log_x = false, log_y = false;               ///< kinks, transitions: lines in these axes
  std::size_t kinks = 1;
  bool curved = false;             ///< kink: branches beyond the kinks bend
  std::string direction = "both";  ///< jump, curved kinks: up, down, both
  double least_factor = 2.0;       ///< jump
  std::vector<double> rates;       ///< transition: two; empty: the smallest two
  std::optional<double> split;     ///< transition
  std::string of = "crossover";    ///< divergence: crossover, jump, transition, value
  std::string weigh = "auto";      ///< divergence: auto, alike (in ln y), errors
  std::optional<double> pressure;  ///< constant-pressure, [m/tau_e^2]
  std::size_t window = 3;          ///< exponents: points a local slope is taken over
  std::uint32_t resamples = 400;   ///< of the bootstrap; 0: none
  std::uint64_t seed = 1;          ///< of the bootstrap
};

}  // namespace bagnold::analysis
