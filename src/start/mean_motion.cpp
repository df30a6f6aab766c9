// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/mean_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/physics/species.hpp"
#include "src/config/strain_rates.hpp"

namespace bagnold {

MeanMotion mean_motion(State const& state, Scene const& scene) {
  double const rate = state.strain_rate.value_or(scene.shear.strain_rate);
  double masses = 0, x = 0, y = 0, squares = 0;
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const mass = disk_mass(scene.mass_by_area(), state.diameter[i]);
    double const dv_x = state.velocity[i][0] - rate * state.position[i][1];
    double const dv_y = state.velocity[i][1];
    masses += mass;
    x += mass * dv_x;
    y += mass * dv_y;
    squares += mass * (dv_x * dv_x + dv_y * dv_y);
  }
  double const share = squares > 0 ? (x * x + y * y) / (masses * squares) : 0;
  return {{x / masses, y / masses}, share};
}

bool is_more_than_rounding(MeanMotion const& motion, double rate, double height) {
  constexpr double rounding = 1e-6;
  auto const [x, y] = motion.velocity;
  return std::hypot(x, y) >
         std::max(rounding * std::abs(rate), std::numeric_limits<double>::epsilon() * height);
}

std::optional<MeanMotion> take_off_mean_motion(State& state, Scene const& scene) {
  // Rounding leaves a share below 1e-20 in states of this program. A strain of 1e4 makes 1e-4 of
  // this limit.
  constexpr double rounding = 1e-12;
  auto const found = mean_motion(state, scene);
  double const rate = scene.shear.by_pieces() ? typical_rate(scene)
                                              : state.strain_rate.value_or(scene.shear.strain_rate);
  if (!(found.share > rounding &&
        is_more_than_rounding(found, rate, state.box_aspect * state.box_length)))
    return std::nullopt;
  for (auto& v : state.velocity) v = {v[0] - found.velocity[0], v[1] - found.velocity[1]};
  return found;
}

}  // namespace bagnold
