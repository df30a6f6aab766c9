// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/analysis/curves.hpp"
#include "src/analysis/fit/points.hpp"
#include "src/analysis/request.hpp"

namespace bagnold::analysis {

/// A curve as points to fit, in order of x.
struct Series {
  std::vector<Label> labels;
  std::vector<double> x_error;                          ///< of the measured points
  std::function<Points(std::uint32_t replica)> points;  ///< 0: as measured; else resampled
  std::size_t left_out = 0;  ///< data without a value, or without an error
  std::size_t pooled = 0;    ///< data that weigh by a pooled error
  double widened = 1.0;      ///< see Quantity
  bool alike = false;        ///< points weigh alike in ln y, whatever their errors (fit_all)
};

/// y against x for every curve of the sweep. Data without x or y (failed, undefined) are left out.
/// Those without an error of their own weigh by a pooled one (SeedErrors). Weights of resampled
/// points are those of the measured ones. Keeps a reference to the table.
std::vector<Series> make_series(SweepTable const& table, Request const& request,
                                std::string const& x, std::string const& y);

/// y(gammadot_1) - y(gammadot_2) against the key x, for the two strain rates of the request or the
/// smallest two, gammadot_1 < gammadot_2; errors added as independent. P2 App. A. A curve that is
/// not at both rates has no points, and comes after the others.
std::vector<Series> make_differences(SweepTable const& table, Request const& request,
                                     std::string const& x, std::string const& y);

/// Key that varies along a curve of x.
std::string running_key(Request const& request, std::string const& x);

}  // namespace bagnold::analysis
