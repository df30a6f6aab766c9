// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/oscillation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "src/config/errors.hpp"
#include "src/config/scene.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

/// sin(2 pi k / K): exactly 0, 1 or -1 where it is, and odd and even about these places.
long double sine(std::int64_t k, std::int64_t K) {
  if (2 * k > K) return -sine(K - k, K);
  if (4 * k > K)
    k = K - 2 * k;
  else
    k *= 2;
  return std::sin(std::numbers::pi_v<long double> * static_cast<long double>(k) /
                  static_cast<long double>(K));
}

DoubleDouble split(long double number) {
  auto const high = static_cast<double>(number);
  return {high, static_cast<double>(number - high)};
}

}  // namespace

double oscillation_period(Scene const& scene) {
  auto const& shear = scene.shear;
  if (shear.period) return *shear.period;
  return 2 * std::numbers::pi * shear.amplitude / shear.peak_rate.value_or(0);
}

PieceTable make_oscillation(Scene const& scene) {
  auto const& shear = scene.shear;
  double const dt = time_step(scene);
  std::int64_t const count = shear.cycle_pieces;
  double const piece = oscillation_period(scene) / static_cast<double>(count);
  double const steps = std::round(piece / dt);
  if (!(std::abs(steps * dt - piece) <= 1e-9 * piece))
    throw InputError(fmt::format(
        "integration.time_step = {} (must divide a piece of the cycle, {} tau_e, so that the rate "
        "changes between steps); use {} or leave it out",
        dt, piece, piece / round_up(piece / dt)));
  double const all = steps * static_cast<double>(count) * static_cast<double>(shear.cycles);
  if (!(all * static_cast<double>(scene.disks.replicas) <= most_steps))
    throw InputError(fmt::format(
        "shear.cycles = {} take {:.3g} steps (limit {:.0g}); take fewer, or a shorter period",
        shear.cycles, all, most_steps));
  PieceTable table(dt, shear.cycles);
  auto const duration = static_cast<long double>(steps) * dt;
  long double before = 0;
  for (std::int64_t k = 1; k <= count; ++k) {
    long double const after = shear.amplitude * sine(k, count);
    table.add(static_cast<std::int64_t>(steps), static_cast<double>((after - before) / duration),
              split(after));
    before = after;
  }
  return table;
}

}  // namespace bagnold
