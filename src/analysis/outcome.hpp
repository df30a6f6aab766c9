// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/analysis/curves.hpp"
#include "src/analysis/fit/fit.hpp"
#include "src/analysis/request.hpp"

namespace bagnold::analysis {

/// A line to draw.
struct Line {
  std::vector<double> x, y;
};

/// Result of a fit to one curve.
struct FitResult {
  std::vector<double> value, error;  ///< [parameters]
  double chi2 = unknown;
  std::size_t freedom = 0;
  std::size_t points = 0;
  std::vector<Line> lines = {};
  bool weighted = true;  ///< the points had errors
  double misfit = 0.0;   ///< of the law, relative: added to errors of points, see fit_all
  bool alike = false;    ///< points weighed alike in ln y, the misfit being their scatter
  bool step = false;     ///< the place is known to lie between two points, its error is theirs
  std::vector<double> grid = {};  ///< [parameters] or empty: of the points' spacing, see carry_out
  double widened = 1.0;           ///< errors are those of a good fit, times this (carry_out)
};

/// A fit to make, on the measured points (replica 0) or on resampled ones.
struct Task {
  std::vector<Label> labels;
  std::function<FitResult(std::uint32_t replica)> find;
};

struct Outcome {
  std::vector<Label> labels;
  FitResult found;                            ///< empty where it failed
  std::string failure;                        ///< why nothing was found; empty: all is well
  std::vector<std::vector<double>> replicas;  ///< [resamples][parameters], NaN where one failed
  std::vector<double> bootstrap;  ///< standard deviation over replicas, NaN if over half failed
};

/// True if chi2 is larger than its degrees of freedom allow but once in a thousand. False without
/// errors of the points.
bool beyond_chance(FitResult const& found);

/// Does all tasks. A task that fails does not stop the others; where all fail, throws InputError
/// with the first reason.
///
/// Errors of a fit whose chi2 is beyond chance, without a misfit of the law that allows for it, are
/// multiplied by (chi2 / freedom)^(1/2), the scale factor of the Particle Data Group (Navas et al.,
/// PRD 110, 030001 (2024), Sec. 5.2.2). Errors from the scatter about the fit (these, those with a
/// misfit and those of points without errors) are multiplied by Student's factor of its degrees of
/// freedom. The uncertainty of a place between points (FitResult::grid) is added as independent;
/// the bootstrap draws it uniformly over 12^(1/2) times that.
std::vector<Outcome> carry_out(std::vector<Task> const& tasks, Request const& request);

/// A curve sampled at 200 places between two x, evenly in ln x where asked for.
Line sample_line(double low, double high, bool log_x, std::function<double(double)> const& curve);

}  // namespace bagnold::analysis
