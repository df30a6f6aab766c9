// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/kinds/curved_kink.hpp"

#include <algorithm>
#include <cmath>

#include "src/analysis/fit/branches.hpp"

namespace bagnold::analysis {
namespace {

struct Allowed {
  Branches curve;
  double misfit;  ///< of y, or of ln y
  double chi2;    ///< with errors as measured
  bool weighted;
};

Points with_misfit(Points points, double misfit, bool log_y) {
  for (std::size_t k = 0; k < points.error.size(); ++k)
    points.error[k] = std::hypot(points.error[k], misfit * (log_y ? 1.0 : points.y[k]));
  return points;
}

bool beyond_chance(Fit const& fit, bool weighted) {
  FitResult out{{}, {}, fit.chi2, fit.freedom};
  out.weighted = weighted;
  return analysis::beyond_chance(out);
}

/// True if a polynomial with as many parameters describes the points within chance.
bool is_smooth(Points const& points, std::size_t parameters) {
  return points.weighted() && !beyond_chance(fit_polynomial(points, parameters), true);
}

/// Fits the curve with the misfit at which chi2 equals its degrees of freedom; without a misfit if
/// chi2 is within chance.
Allowed fit_allowing(Points const& points, Request const& request, std::size_t left_degree) {
  auto const first = fit_branches(points, request.kinks, left_degree, 2);
  Allowed out{first, 0.0, first.fit.chi2, points.weighted()};
  if (!beyond_chance(first.fit, points.weighted())) return out;
  double low = 1e-4, high = 1.0;
  constexpr int halvings = 12;  // of ln m: m to a fifth of a per cent
  for (int i = 0; i < halvings; ++i) {
    double const middle = std::sqrt(low * high);
    auto now =
        fit_branches(with_misfit(points, middle, request.log_y), request.kinks, left_degree, 2);
    if (now.fit.chi2 > static_cast<double>(now.fit.freedom)) {
      low = middle;
    } else {
      high = middle;
      out.curve = std::move(now);
      out.misfit = middle;
    }
  }
  return out;
}

bool is_clear(Branches const& curve, std::size_t k) {
  constexpr double clear = 3.0;
  return std::abs(curve.bend(k)) > clear * curve.bend_error(k);
}

/// True if the first kink bends as requested and the next one the other way.
bool bends_as_asked(double bend, std::size_t k, std::string const& direction) {
  if (direction == "both") return true;
  return (bend > 0.0) == ((direction == "up") == (k % 2 == 0));
}

bool stands(Branches const& one, Branches const& other, std::size_t k, Request const& request) {
  constexpr double alike = 2.0;
  return is_clear(one, k) && is_clear(other, k) && one.bend(k) * other.bend(k) > 0.0 &&
         bends_as_asked(one.bend(k), k, request.direction) &&
         std::abs(one.place(k) - other.place(k)) <=
             alike * std::hypot(one.place_error(k), other.place_error(k));
}

}  // namespace

FitResult CurvedKinks::operator()(Points const& measured, std::uint32_t replica) const {
  auto const points = with_logarithms(measured, request_.log_x, request_.log_y);
  auto const x_of = [&](double x) { return request_.log_x ? std::exp(x) : x; };
  auto const y_of = [&](double y) { return request_.log_y ? std::exp(y) : y; };
  FitResult out;
  out.points = points.size();
  out.weighted = points.weighted();
  auto const add = [&](Branches const& curve, std::size_t k, double difference) {
    double const place = x_of(curve.place(k));
    bool const given = known_->stands[k];
    double const error = std::hypot(curve.place_error(k), difference);
    double const scale = request_.log_x ? place : 1.0;
    out.value.insert(out.value.end(),
                     {given ? place : unknown, given ? y_of(curve(curve.place(k))) : unknown});
    out.error.insert(out.error.end(), {given ? error * scale : unknown, unknown});
    out.grid.insert(out.grid.end(), {grid_error(points, curve.place(k)) * scale, 0.0});
  };
  if (replica != 0) {
    auto const curve =
        fit_branches(with_misfit(points, known_->misfit, request_.log_y), request_.kinks, 2, 2);
    for (std::size_t k = 0; k < request_.kinks; ++k) add(curve, k, 0.0);
    return out;
  }
  auto const second = fit_allowing(points, request_, 2), third = fit_allowing(points, request_, 3);
  *known_ = {second.misfit, {}};
  bool const smooth = is_smooth(points, second.curve.fit.value.size());
  for (std::size_t k = 0; k < request_.kinks; ++k) {
    known_->stands.push_back(!smooth && stands(second.curve, third.curve, k, request_));
    add(second.curve, k, second.curve.place(k) - third.curve.place(k));
  }
  out.chi2 = second.chi2;
  out.freedom = second.curve.fit.freedom;
  out.misfit = second.misfit;
  auto line = sample_line(points.x.front(), points.x.back(), false, second.curve);
  std::ranges::transform(line.x, line.x.begin(), x_of);
  std::ranges::transform(line.y, line.y.begin(), y_of);
  out.lines.push_back(std::move(line));
  return out;
}

}  // namespace bagnold::analysis
