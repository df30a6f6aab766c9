// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/levenberg_marquardt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>

#include "src/analysis/fit/covariance.hpp"
#include "src/analysis/fit/starts.hpp"
#include "src/analysis/fit/weights.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

using Values = std::vector<double>;

double inside_of(Parameter const& parameter, double value) {
  return std::isfinite(parameter.above) ? std::log(value - parameter.above) : value;
}
double outside_of(Parameter const& parameter, double inside) {
  return std::isfinite(parameter.above) ? parameter.above + std::exp(inside) : inside;
}
/// d value / d inside
double slope_of(Parameter const& parameter, double value) {
  return std::isfinite(parameter.above) ? value - parameter.above : 1.0;
}

/// Weighted residuals of the free parameters, in the form that Eigen asks for.
struct Residuals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  Model const* model;
  Points const* points;
  std::vector<std::size_t> free;
  Values all;   ///< fixed parameters at their values
  Values unit;  ///< [free], what each is measured in: columns of the Jacobian are of length 1

  int inputs() const { return static_cast<int>(free.size()); }
  int values() const { return static_cast<int>(points->size()); }

  Values parameters(InputType const& inside) const {
    Values out = all;
    for (std::size_t k = 0; k < free.size(); ++k)
      out[free[k]] =
          outside_of(model->parameters[free[k]], unit[k] * inside[static_cast<Eigen::Index>(k)]);
    return out;
  }

  int operator()(InputType const& inside, ValueType& residual) const {
    constexpr double out_of_reach = 1e60;  // has a finite square
    auto const now = parameters(inside);
    auto const weight = weights(*points);
    for (std::size_t i = 0; i < points->size(); ++i) {
      auto const row = static_cast<Eigen::Index>(i);
      residual[row] = (points->y[i] - model->value(points->x[i], now)) * weight[row];
      if (!(std::abs(residual[row]) < out_of_reach)) residual[row] = out_of_reach;
    }
    return 0;
  }

  /// Jacobian from central differences.
  int df(InputType const& inside, JacobianType& jacobian) const {
    ValueType above(values()), below(values());
    double const enough = 1e-9 * weighted_values(*points).norm();
    for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
      auto const column = static_cast<std::size_t>(k);
      auto const difference = [&](double step) {
        auto moved = inside;
        moved[k] = inside[k] + step;
        (*this)(moved, above);
        moved[k] = inside[k] - step;
        (*this)(moved, below);
        return (above - below).norm();
      };
      double step = step_of(free[column], unit[column] * inside[k]) / unit[column];
      // an amplitude may start at zero but for rounding: its own size is no measure then
      int growths = is_amplitude(free[column]) ? 20 : 0;
      while (difference(step) < enough && growths-- > 0) step *= 10.0;
      jacobian.col(k) = (above - below) / (2.0 * step);
    }
    return 2 * inputs();
  }

 private:
  bool is_amplitude(std::size_t parameter) const {
    return model->parameters[parameter].guesses.empty();
  }

  /// Step that balances rounding and curvature, epsilon^(1/3) of the size: of an amplitude its own,
  /// of logarithms and exponents at least one, for they change a curve as much where they are zero.
  double step_of(std::size_t parameter, double variable) const {
    constexpr double share = 6e-6;
    double const size = std::abs(variable);
    return share * (is_amplitude(parameter) && size > 0.0 ? size : std::max(size, 1.0));
  }
};

Residuals residuals_of(Model const& model, Points const& points, Fixed const& fixed,
                       Values const& start) {
  Residuals out{&model, &points, {}, start, {}};
  for (std::size_t k = 0; k < model.parameters.size(); ++k)
    if (auto const found = fixed.find(model.parameters[k].name); found != fixed.end())
      out.all[k] = found->second;
    else
      out.free.push_back(k);
  out.unit.assign(out.free.size(), 1.0);
  return out;
}

void check_fixed(Model const& model, Fixed const& fixed) {
  for (auto const& [name, value] : fixed) {
    auto const found =
        std::ranges::find_if(model.parameters, [&](auto const& p) { return p.name == name; });
    if (found == model.parameters.end())
      throw InputError(fmt::format("--fix {} = {} (no parameter of the {} has that name)", name,
                                   value, model.name));
    if (!std::isfinite(value) || value <= found->above)
      throw InputError(fmt::format("{} = {} (must lie above {})", name, value, found->above));
  }
}

/// The search takes a column of the Jacobian below 1e-15 of the longest for none. Where columns
/// differ by so much, as of stresses of slow flows, which are as small as the rate squared,
/// parameters are measured in units that make them of length 1.
void measure_in_units(Residuals& residuals, Eigen::VectorXd& inside) {
  constexpr double far_apart = 1e6;
  Eigen::MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.df(inside, jacobian);
  Eigen::VectorXd const length = jacobian.colwise().norm();
  if (!length.allFinite() || !(length.minCoeff() > 0.0) ||
      length.maxCoeff() < far_apart * length.minCoeff())
    return;
  for (Eigen::Index k = 0; k < length.size(); ++k) {
    residuals.unit[static_cast<std::size_t>(k)] = 1.0 / length[k];
    inside[k] *= length[k];
  }
}

}  // namespace

Fit fit_from(Model const& model, Points const& points, Fixed const& fixed, Values const& start) {
  check_fixed(model, fixed);
  auto residuals = residuals_of(model, points, fixed, start);
  auto const& free = residuals.free;
  check_points(points, std::max<std::size_t>(free.size(), 2), model.name + " fit");
  Eigen::VectorXd inside(static_cast<Eigen::Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k)
    inside[static_cast<Eigen::Index>(k)] =
        inside_of(model.parameters[free[k]], residuals.all.at(free[k]));
  if (!free.empty()) {
    measure_in_units(residuals, inside);
    Eigen::LevenbergMarquardt<Residuals> search(residuals);
    search.parameters.ftol = search.parameters.xtol = 1e-13;
    search.parameters.maxfev = 1000;
    auto const status = search.minimize(inside);
    if (status <= 0 || status == Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation)
      throw InputError(
          fmt::format("{} fit: no convergence; fix parameters (--fix), or add points", model.name));
  }
  Fit out;
  out.value = residuals.parameters(inside);
  Eigen::VectorXd residual(residuals.values());
  residuals(inside, residual);
  out.chi2 = residual.squaredNorm();
  out.freedom = points.size() - free.size();
  auto const size = out.value.size();
  out.covariance.assign(size * size, 0.0);
  out.error.assign(size, 0.0);
  if (free.empty()) return out;

  Eigen::MatrixXd jacobian(residuals.values(), residuals.inputs());
  residuals.df(inside, jacobian);
  for (std::size_t k = 0; k < free.size(); ++k)
    jacobian.col(static_cast<Eigen::Index>(k)) /=
        residuals.unit[k] * slope_of(model.parameters[free[k]], out.value[free[k]]);
  Fit of_free{{}, {}, {}, out.chi2, out.freedom};
  set_covariance(of_free, jacobian, points.weighted());
  for (std::size_t k = 0; k < free.size(); ++k) {
    out.error[free[k]] = of_free.error[k];
    for (std::size_t l = 0; l < free.size(); ++l)
      out.covariance[free[k] * size + free[l]] = of_free.covariance[k * free.size() + l];
  }
  return out;
}

Fit fit(Model const& model, Points const& points, Fixed const& fixed) {
  constexpr std::size_t tries = 3;
  check_fixed(model, fixed);
  check_points(points, 2, model.name + " fit");
  auto const ranked = starts(model, points, fixed);
  std::optional<Fit> best;
  std::string reason = model.name + " fit: no finite start; is x in the model's range?";
  for (std::size_t k = 0; k < std::min(tries, ranked.size()); ++k) try {
      auto found = fit_from(model, points, fixed, ranked[k].second);
      if (!best || found.chi2 < best->chi2) best = std::move(found);
    } catch (InputError const& error) {
      reason = error.what();
    }
  if (!best) throw InputError(reason);
  return *best;
}

}  // namespace bagnold::analysis
