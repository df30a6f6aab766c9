// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Results besides series: named tables of numbers, NaN where undefined. For a ramp each frame has
/// its own numbers. Their leading axes are then `frames`, {F}, or {R, F} for several systems.
namespace bagnold::statistics {

/// Distribution of a quantity.
struct Histogram {
  std::string name;
  std::string unit;  ///< of the edges; the density is per that
  std::string description;
  std::vector<double> edges;    ///< [n + 1], ascending
  std::vector<double> density;  ///< [n]; its integral is the share that lies within the edges
  std::vector<std::size_t> frames = {};
};

/// A quantity as a function of y.
struct Profile {
  std::string name;
  std::string unit;  ///< of the values
  std::string description;
  std::vector<double> y;      ///< [n], centres of the bins, [d_s]
  std::vector<double> value;  ///< [n]
  std::vector<double> error;  ///< [n], one standard deviation of the mean; of a frame there is none
  std::vector<std::size_t> frames = {};
};

/// Rows of numbers that belong together.
struct Samples {
  std::string name;
  std::string description;
  std::vector<std::string> columns;  ///< name of each, with its unit: "x [d_s]"
  std::vector<double> rows;          ///< [rows][columns]
};

}  // namespace bagnold::statistics
