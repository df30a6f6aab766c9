// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace bagnold {

struct Scene;

/// The strain rate of a ramp over its steps, P2 Eqs. (38), (39):
///
///     gammadot(t + T) = gammadot(t) 10^(+-kappa~ T),   T = ramp_every, P2: 1 tau_e.
///
/// First `strain` at 1e-3 (from a random start only, and where the lowest rate is below), the same
/// at the lowest rate; then `cycles` times up and down. A leg up has K pieces of rate
/// gammadot_low 10^(kappa~ T j), j = 0 .. K - 1, a leg down the same in the opposite order, so that
/// both strain alike. All stretches are whole windows long, which may take a leg beyond
/// `strain_rate_high` by less than a window.
struct Ramp {
  double time_step = 0;           ///< dt, [tau_e]
  double lowest = 0;              ///< gammadot_low, [1/tau_e]
  double growth = 0;              ///< kappa T = ln 10 kappa~ T, of ln(gammadot) a piece
  std::int64_t fast_steps = 0;    ///< at fast_rate, first
  std::int64_t slow_steps = 0;    ///< at the lowest rate, then
  std::int64_t piece_steps = 1;   ///< T / dt
  std::int64_t leg_pieces = 0;    ///< K
  std::int64_t legs = 0;          ///< 2 cycles
  std::int64_t window_steps = 1;  ///< a window's

  static constexpr double fast_rate = 1e-3;  ///< [1/tau_e]

  /// Steps at one rate.
  struct Piece {
    std::int64_t begin = 0, end = 0;  ///< steps begin .. end - 1
    double rate = 0;                  ///< [1/tau_e]
    int direction = 0;                ///< +1 on the way up, -1 down, 0 before
  };

  std::int64_t first_leg() const { return fast_steps + slow_steps; }  ///< its first step
  std::int64_t leg_steps() const { return leg_pieces * piece_steps; }
  std::int64_t steps() const { return first_leg() + legs * leg_steps(); }

  /// Piece of a step, 0 <= step < steps().
  Piece piece(std::int64_t step) const;

  /// Strain from step 0 to the start of `step`, summed in closed form: exact to rounding however
  /// many pieces there are.
  long double strain(std::int64_t step) const;

  /// Mean rate over steps begin .. end - 1, [1/tau_e].
  double mean_rate(std::int64_t begin, std::int64_t end) const;

 private:
  double rate_of(std::int64_t power) const;         ///< gammadot_low e^(growth power)
  long double strain_up(std::int64_t steps) const;  ///< of the first steps of a leg up
  long double strain_in_leg(std::int64_t leg, std::int64_t steps) const;
};

/// The ramp of a scene with that protocol. Throws InputError where the time step does not divide
/// ramp_every, or ramp_every the window.
Ramp make_ramp(Scene const& scene);

}  // namespace bagnold
