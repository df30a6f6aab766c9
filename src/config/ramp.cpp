// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/ramp.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "src/config/errors.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

double Ramp::rate_of(std::int64_t power) const {
  return static_cast<double>(lowest * std::exp(static_cast<long double>(growth) * power));
}

/// Geometric sum: gammadot_low T (q^k - 1) / (q - 1) over k whole pieces, q = e^growth.
long double Ramp::strain_up(std::int64_t steps) const {
  long double const step_time = time_step, q = growth;
  std::int64_t const whole = steps / piece_steps, rest = steps % piece_steps;
  return step_time *
         (lowest * static_cast<long double>(piece_steps) * (std::expm1(q * whole) / std::expm1(q)) +
          rate_of(whole) * static_cast<long double>(rest));
}

long double Ramp::strain_in_leg(std::int64_t leg, std::int64_t steps) const {
  return leg % 2 == 0 ? strain_up(steps) : strain_up(leg_steps()) - strain_up(leg_steps() - steps);
}

long double Ramp::strain(std::int64_t step) const {
  long double const step_time = time_step;
  if (step < fast_steps) return step_time * fast_rate * step;
  long double const fast = step_time * fast_rate * fast_steps;
  if (step < first_leg()) return fast + step_time * lowest * (step - fast_steps);
  std::int64_t const leg = (step - first_leg()) / leg_steps(),
                     in_leg = (step - first_leg()) % leg_steps();
  return fast + step_time * lowest * slow_steps + leg * strain_up(leg_steps()) +
         strain_in_leg(leg, in_leg);
}

Ramp::Piece Ramp::piece(std::int64_t step) const {
  if (step < fast_steps) return {0, fast_steps, fast_rate, 0};
  if (step < first_leg()) return {fast_steps, first_leg(), lowest, 0};
  std::int64_t const leg = (step - first_leg()) / leg_steps();
  std::int64_t const k = (step - first_leg()) % leg_steps() / piece_steps;
  std::int64_t const begin = first_leg() + leg * leg_steps() + k * piece_steps;
  bool const up = leg % 2 == 0;
  return {begin, begin + piece_steps, rate_of(up ? k : leg_pieces - 1 - k), up ? 1 : -1};
}

double Ramp::mean_rate(std::int64_t begin, std::int64_t end) const {
  return static_cast<double>((strain(end) - strain(begin)) /
                             (static_cast<long double>(time_step) * (end - begin)));
}

namespace {

/// a / b where that is whole to rounding, else 0.
double whole_quotient(double a, double b) {
  double const quotient = std::round(a / b);
  return std::abs(quotient * b - a) <= 1e-9 * a ? quotient : 0;
}

}  // namespace

Ramp make_ramp(Scene const& scene) {
  auto const& shear = scene.shear;
  Ramp ramp;
  ramp.time_step = time_step(scene);
  ramp.lowest = shear.strain_rate;
  ramp.growth = shear.ramp_rate * shear.ramp_every * std::numbers::ln10;
  double const piece = whole_quotient(shear.ramp_every, ramp.time_step);
  if (piece == 0)
    throw InputError(
        fmt::format("integration.time_step = {} (must divide shear.ramp_every = {}: the rate "
                    "changes between steps); "
                    "use {} or leave it out",
                    ramp.time_step, shear.ramp_every,
                    shear.ramp_every / round_up(shear.ramp_every / ramp.time_step)));
  double const window_pieces = whole_quotient(shear.ramp_window, shear.ramp_every);
  if (window_pieces == 0)
    throw InputError(fmt::format(
        "shear.ramp_window = {} (must be a whole number of shear.ramp_every = {}); use {}",
        shear.ramp_window, shear.ramp_every,
        shear.ramp_every * std::max(1.0, std::round(shear.ramp_window / shear.ramp_every))));

  double const window = window_pieces * piece;  // [steps]
  auto const whole_windows = [&](double steps) { return window * round_up(steps / window); };
  double const leg = whole_windows(std::log10(shear.strain_rate_high / shear.strain_rate) /
                                   shear.ramp_rate / ramp.time_step);
  bool const by_way = scene.start.kind == "random" && shear.strain_rate < Ramp::fast_rate;
  double const fast = by_way ? whole_windows(shear.strain / (Ramp::fast_rate * ramp.time_step)) : 0;
  double const slow = whole_windows(shear.strain / (shear.strain_rate * ramp.time_step));
  double const legs = 2 * static_cast<double>(shear.cycles);
  double const steps = fast + slow + legs * leg;
  if (!(steps * static_cast<double>(scene.disks.replicas) <= most_steps))
    throw InputError(
        fmt::format("shear.ramp_rate = {} takes {:.3g} steps (limit {:.0g}); raise it, or "
                    "shear.strain_rate = {}",
                    shear.ramp_rate, steps, most_steps, shear.strain_rate));
  ramp.piece_steps = static_cast<std::int64_t>(piece);
  ramp.window_steps = static_cast<std::int64_t>(window);
  ramp.fast_steps = static_cast<std::int64_t>(fast);
  ramp.slow_steps = static_cast<std::int64_t>(slow);
  ramp.leg_pieces = static_cast<std::int64_t>(leg / piece);
  ramp.legs = 2 * shear.cycles;
  return ramp;
}

}  // namespace bagnold
