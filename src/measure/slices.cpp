// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/slices.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "src/measure/circle_overlap.hpp"

namespace bagnold {

namespace {

using C = SliceColumns;

constexpr double least_thickness = 1.5;  // [d_s]
constexpr std::size_t fewest = 8;

/// Cuts a disk at y, in 0 .. L_y, along the edges of the slices.
void add_area(Slices const& slices, double y, double radius, std::vector<double>& sums) {
  double const thickness = slices.thickness();
  auto const n = static_cast<long>(slices.n);
  auto const first = static_cast<long>(std::floor((y - radius) / thickness));
  auto const last = static_cast<long>(std::floor((y + radius) / thickness));
  double below = 0.0;
  for (long k = first; k <= last; ++k) {
    double const next = circle_below(radius, static_cast<double>(k + 1) * thickness - y);
    auto const slice = static_cast<std::size_t>(((k % n) + n) % n);
    sums[slice * C::count + C::area] += next - below;
    below = next;
  }
}

void add_motion(std::span<double> s, double mass, double h, double w, double vy) {
  s[C::disks] += 1;
  s[C::mass] += mass;
  s[C::height] += mass * h;
  s[C::height2] += mass * h * h;
  s[C::flow_x] += mass * w;
  s[C::flow_y] += mass * vy;
  s[C::shear_x] += mass * h * w;
  s[C::shear_y] += mass * h * vy;
  s[C::kinetic_xx] += mass * w * w;
  s[C::kinetic_xy] += mass * w * vy;
  s[C::kinetic_yy] += mass * vy * vy;
}

void add_stress(std::span<double> s, Sums<false> const& stress) {
  for (int c = SumColumns::elastic_xx; c <= SumColumns::dissipative_yy; ++c)
    s[C::elastic_xx + c - SumColumns::elastic_xx] += stress.value[c];
  s[C::contacts] += stress.value[SumColumns::contacts];
}
static_assert(C::dissipative_yy - C::elastic_xx ==
              SumColumns::dissipative_yy - SumColumns::elastic_xx);

}  // namespace

Slices::Slices(double width, double height)
    : width(width),
      height(height),
      n(std::max(fewest, static_cast<std::size_t>(height / least_thickness))) {}

std::vector<double> slice_sums(Slices const& slices, State const& state,
                               std::vector<double> const& mass,
                               std::vector<Sums<false>> const& stress, double origin) {
  std::vector<double> sums(slices.n * C::count);
  double const rate = state.strain_rate.value();
  for (std::size_t i = 0; i < state.count(); ++i) {
    double y = state.position[i][1] - origin;
    y -= slices.height * std::floor(y / slices.height);
    auto const slice =
        std::min(static_cast<std::size_t>(y / slices.thickness()), slices.n - 1);  // y may be L_y
    std::span const s(&sums[slice * C::count], C::count);
    double const w = state.velocity[i][0] - rate * state.position[i][1];
    add_area(slices, y, state.diameter[i] / 2, sums);
    add_motion(s, mass[i], y - slices.middle(slice), w, state.velocity[i][1]);
    add_stress(s, stress[i]);
    if (!state.spin.empty()) s[C::spin] += state.spin[i];
  }
  return sums;
}

}  // namespace bagnold
