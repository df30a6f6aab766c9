// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

struct Parameter {
  std::string name;
  bool linear = false;  ///< the model is linear and homogeneous in all parameters so marked
  double above = -std::numeric_limits<double>::infinity();  ///< values lie above this
  std::vector<double> guesses = {};  ///< where a fit starts; none for linear ones
};

/// A curve with parameters, of one variable x.
struct Model {
  std::string name;
  std::vector<Parameter> parameters;
  std::function<double(double x, std::span<double const> parameters)> value;
};

/// C [1 + (x/x*)^s]^(q/s), with parameters C, x*, s, q. P1 Sec. III A (unnumbered, above Fig. 4):
/// Bagnold coefficients against Q, x* = Q*(phi); C at small Q, x^q at large Q, s the sharpness.
Model crossover_model(Points const& points);

/// Q0 + c (phi_J - phi)^-x, with parameters Q0, c, phi_J, x. P1 Sec. III B and Fig. 5a for Q*(phi),
/// P2 Fig. 3 for Q_c(phi). phi_J lies above all phi of the points, x above 0.
Model divergence_model(Points const& points);

/// Logarithm of a model. None of its parameters is linear, so it is fitted from a known start.
Model logarithm_of(Model model);

/// mu_J + c I^b, with parameters mu_J, c, b. P1 Eq. (21) and Fig. 15. b above 0.
Model friction_law_model();

}  // namespace bagnold::analysis
