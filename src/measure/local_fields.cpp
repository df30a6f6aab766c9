// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/local_fields.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "src/config/plan.hpp"
#include "src/measure/circle_overlap.hpp"
#include "src/measure/disk_search.hpp"

namespace bagnold {

namespace {

/// Reach of the search: every disk that overlaps a circle about a small disk is within d_ij + this.
constexpr double search_reach = field_radius - small_diameter / 2;

/// Weighted sums for the plane w = a + b x + c y.
struct PlaneFit {
  double n = 0, x = 0, y = 0, w = 0, xx = 0, xy = 0, yy = 0, xw = 0, yw = 0;
  int points = 0;

  void add(double weight, Vec2<Real> at, double value) {
    ++points;
    n += weight;
    x += weight * at.x;
    y += weight * at.y;
    w += weight * value;
    xx += weight * at.x * at.x;
    xy += weight * at.x * at.y;
    yy += weight * at.y * at.y;
    xw += weight * at.x * value;
    yw += weight * at.y * value;
  }

  /// c; NaN if it is not determined.
  double slope_y() const {
    double const XX = xx - x * x / n, XY = xy - x * y / n, YY = yy - y * y / n;
    double const XW = xw - x * w / n, YW = yw - y * w / n;
    double const determinant = XX * YY - XY * XY;
    bool const open = points < 3 || !(determinant > 1e-9 * XX * YY);
    return open ? std::numeric_limits<double>::quiet_NaN() : (XX * YW - XY * XW) / determinant;
  }
};

}  // namespace

LocalFields local_fields(State const& state) {
  auto const search = disk_search(state, search_reach);
  double const rate = state.strain_rate.value();
  auto const excess = [&](std::size_t i) {
    return state.velocity[i][0] - rate * state.position[i][1];  // the same for all images
  };
  LocalFields fields;
  for (std::uint32_t i = 0; i < state.count(); ++i) {
    double area = 0.0;
    PlaneFit fit;
    auto const add = [&](std::size_t j, Vec2<Real> from_i) {
      double const part =
          circle_overlap(field_radius, state.diameter[j] / 2, std::sqrt(dot(from_i, from_i)));
      if (part > 0) fit.add(part, from_i, excess(j));
      area += part;
    };
    add(i, {0.0, 0.0});
    search(i, [&](Neighbor const& neighbor) {
      auto const j = neighbor.index();
      add(j, search.position(j) + search.box.shift(neighbor.image()) - search.position(i));
    });
    fields.packing_fraction.push_back(area / (std::numbers::pi * field_radius * field_radius));
    fields.strain_rate.push_back(rate + fit.slope_y());
  }
  return fields;
}

}  // namespace bagnold
