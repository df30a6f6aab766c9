// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/grain_units.hpp"

#include <cmath>
#include <numbers>

namespace bagnold {

GrainUnits units_of(Grains const& grains, double disk_mass) {
  constexpr double pi = std::numbers::pi;
  auto const& [d, density, modulus, poisson, speed, restitution] = grains;
  GrainUnits units{};
  units.grain_mass = density * pi / 6 * d * d * d;
  double const stiff = modulus / (2 * (1 - poisson * poisson));
  units.duration =
      2.87 * std::pow(std::pow(units.grain_mass / 2, 2) / (d / 4 * stiff * stiff * speed), 0.2);
  double const turns = pi / std::log(restitution);
  units.elasticity = std::sqrt((turns * turns + 1) / (2 * disk_mass));
  double const beta = 1 / (disk_mass * units.elasticity);
  units.time = units.duration / (pi / std::sqrt(2 / disk_mass - beta * beta));
  units.mass = units.grain_mass / disk_mass;
  return units;
}

}  // namespace bagnold
