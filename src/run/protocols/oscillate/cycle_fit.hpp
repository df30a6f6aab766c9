// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bagnold {

/// Fit of least squares to the stress of the K windows of a cycle.
///
/// The last term is the drift D (Cycles). It is near a sum of harmonics: to fit it beside them
/// makes the error of G' in a flow that fluctuates 2.5 times as large. So it is given where there
/// are other cycles to take it from.
class CycleFit {
 public:
  /// terms: [K] rows of as many terms each, the first a constant.
  explicit CycleFit(std::vector<std::vector<double>> const& terms);
  ~CycleFit();

  /// Coefficients of all terms but the constant: G'_1, G''_1, G'_2, ... and the change of sigma in
  /// a cycle. drift: that, if it is known.
  std::vector<double> operator()(std::span<double const> cycle, std::optional<double> drift) const;

 private:
  struct Solvers;
  std::unique_ptr<Solvers const> solvers_;
};

}  // namespace bagnold
