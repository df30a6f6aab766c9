// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/starts.hpp"

#include <algorithm>
#include <cmath>

#include "src/analysis/fit/least_squares.hpp"
#include "src/analysis/fit/weights.hpp"

namespace bagnold::analysis {
namespace {

using Values = std::vector<double>;

/// Sets the linear parameters to the best fit for the others' values; returns chi2.
double solve_linear(Model const& model, Points const& points, Fixed const& fixed, Values& values) {
  std::vector<std::size_t> solved;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (model.parameters[k].linear) {
      values[k] = 0.0;
      if (auto const found = fixed.find(model.parameters[k].name); found != fixed.end())
        values[k] = found->second;
      else
        solved.push_back(k);
    }
  auto const n = static_cast<Eigen::Index>(points.size());
  auto const weight = weights(points);
  Eigen::MatrixXd basis(n, static_cast<Eigen::Index>(solved.size()));
  Eigen::VectorXd rest = weighted_values(points);
  auto unit = values;
  for (Eigen::Index i = 0; i < n; ++i) {
    double const x = points.x[static_cast<std::size_t>(i)];
    auto const without = model.value(x, values);
    rest[i] -= without * weight[i];
    for (std::size_t k = 0; k < solved.size(); ++k) {
      unit[solved[k]] = 1.0;
      basis(i, static_cast<Eigen::Index>(k)) = (model.value(x, unit) - without) * weight[i];
      unit[solved[k]] = 0.0;
    }
  }
  if (!basis.allFinite() || !rest.allFinite()) return std::numeric_limits<double>::infinity();
  if (solved.empty()) return rest.squaredNorm();
  auto const [best, chi2] = least_squares(basis, rest);
  for (std::size_t k = 0; k < solved.size(); ++k)
    values[solved[k]] = best[static_cast<Eigen::Index>(k)];
  return chi2;
}

}  // namespace

std::vector<std::pair<double, Values>> starts(Model const& model, Points const& points,
                                              Fixed const& fixed) {
  std::vector<Values> combined{{}};
  for (auto const& parameter : model.parameters) {
    Values choices = parameter.linear ? Values{0.0} : parameter.guesses;
    if (auto const found = fixed.find(parameter.name); found != fixed.end())
      choices = {found->second};
    std::vector<Values> longer;
    for (auto const& values : combined)
      for (double const choice : choices) {
        longer.push_back(values);
        longer.back().push_back(choice);
      }
    combined = std::move(longer);
  }
  std::vector<std::pair<double, Values>> ranked;
  for (auto& values : combined) {
    double const chi2 = solve_linear(model, points, fixed, values);
    if (std::isfinite(chi2)) ranked.emplace_back(chi2, std::move(values));
  }
  std::ranges::stable_sort(ranked, {}, &std::pair<double, Values>::first);
  return ranked;
}

}  // namespace bagnold::analysis
