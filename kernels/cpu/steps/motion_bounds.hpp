// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_system.hpp"

namespace bagnold {

/// Observer that keeps the largest peculiar speed of disks and whether a motion is NaN.
struct SpeedBound {
  Real strain_rate;
  simd::Pack fastest2 = 0.0, nan_flag = 0.0;

  /// y: of the disks at the end of the step, [d_s].
  BAGNOLD_INLINE void operator()(simd::Records const& r, simd::Pack y) {
    simd::Pack const ux = fnma(strain_rate, y, r.vx);
    simd::Pack const speed2 = fma(ux, ux, r.vy * r.vy);
    fastest2 = max(fastest2, speed2);
    nan_flag = fma(speed2 + r.x, 0.0, nan_flag);
  }
};

/// Observer that keeps the largest distance of disks from their predicted straight flight, at the
/// new position and at the next trial position.
struct FlightDeviation {
  simd::Record const* origin;
  Real* flight_deviation2;
  Real time;       ///< t of FlightTimes at the end of the step
  Real time_step;  ///< of the next step, at the observed velocities
  Real scale = 1;  ///< q of FlightTimes, of the same velocities

  void all_of(Block const& block, simd::Record const* records) const {
    for (std::uint32_t i = 0; i < block.padded; i += simd::width)
      (*this)(block.first + i, simd::load_records(records + block.first + i));
  }

  void operator()(std::uint32_t slot, simd::Records const& r) const {
    using simd::Pack;
    auto const o = simd::load_records(origin + slot);
    Pack const x = r.x - fma(time, o.vx, o.x), y = r.y - fma(time, o.vy, o.y);
    Pack const next_x = fma(time_step, fnma(scale, o.vx, r.vx), x),
               next_y = fma(time_step, fnma(scale, o.vy, r.vy), y);
    Pack const now2 = fma(x, x, y * y), next2 = fma(next_x, next_x, next_y * next_y);
    max(Pack::load(flight_deviation2 + slot), max(now2, next2)).store(flight_deviation2 + slot);
  }
};

}  // namespace bagnold
