// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/models.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bagnold::analysis {
namespace {

double crossover(double x, std::span<double const> p) {
  double const amplitude = p[0], middle = p[1], s = p[2], q = p[3];
  double const power = s * std::log(x / middle);
  // ln(1 + e^power) without overflow
  double const bracket = std::max(power, 0.0) + std::log1p(std::exp(-std::abs(power)));
  return amplitude * std::exp(q / s * bracket);
}

double divergence(double phi, std::span<double const> p) {
  return p[0] + p[1] * std::pow(p[2] - phi, -p[3]);
}

double friction_law(double inertial_number, std::span<double const> p) {
  return p[0] + p[1] * std::pow(inertial_number, p[2]);
}

}  // namespace

Model crossover_model(Points const& points) {
  std::vector<double> middles;
  auto const [least, most] = std::ranges::minmax(points.x);
  for (int i = 0; i <= 12; ++i) middles.push_back(least * std::pow(most / least, i / 12.0));
  return {"crossover",
          {{"C", true},
           {"Q_star", false, 0.0, middles},
           {"s", false, 0.0, {1.0, 2.0, 4.0, 8.0}},
           {"q", false, -std::numeric_limits<double>::infinity(), {-1.0, 0.5, 1.0, 1.5, 2.0}}},
          crossover};
}

Model divergence_model(Points const& points) {
  auto const [least, most] = std::ranges::minmax(points.x);
  std::vector<double> jammings;
  for (double const share : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0})
    jammings.push_back(most + share * (most - least));
  return {"divergence",
          {{"Q0", true},
           {"c", true},
           {"phi_J", false, most, jammings},
           {"x", false, 0.0, {0.3, 0.6, 1.0, 1.5, 2.0, 3.0, 5.0}}},
          divergence};
}

Model logarithm_of(Model model) {
  for (auto& parameter : model.parameters) parameter.linear = false;
  model.value = [of = std::move(model.value)](double x, std::span<double const> parameters) {
    return std::log(of(x, parameters));
  };
  return model;
}

Model friction_law_model() {
  return {"friction law",
          {{"mu_J", true}, {"c", true}, {"b", false, 0.0, {0.2, 0.4, 0.7, 1.0, 1.5, 2.0}}},
          friction_law};
}

}  // namespace bagnold::analysis
