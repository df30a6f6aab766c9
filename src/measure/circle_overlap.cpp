// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/circle_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bagnold {

namespace {

/// Segment of half angle a of the unit circle.
double segment(double cosine) {
  double const c = std::clamp(cosine, -1.0, 1.0);
  return std::acos(c) - c * std::sqrt(1 - c * c);
}

}  // namespace

double circle_overlap(double R, double r, double d) {
  double const smaller = std::min(R, r);
  if (d >= R + r) return 0.0;
  if (d <= std::abs(R - r)) return std::numbers::pi * smaller * smaller;
  return R * R * segment((d * d + R * R - r * r) / (2 * d * R)) +
         r * r * segment((d * d + r * r - R * R) / (2 * d * r));
}

double circle_below(double r, double t) { return r * r * segment(-t / r); }

}  // namespace bagnold
