// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/islands/free_flight.hpp"
#include "kernels/cpu/islands/sample_times.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"

namespace bagnold {

/// Adds disks in free flight at the times of `powers`.
inline void add_free_flight(BlockSums& sums, FreeFlightSums const& free,
                            SampleTimes::Powers const& powers) {
  using C = SumColumns;
  Real const n = powers.n, t1 = powers.t1, t2 = powers.t2;
  auto* const to = sums.value;
  auto const xx = [=](auto const& m) { return m.aa * n + 2 * m.ab * t1 + m.bb * t2; };
  to[C::kinetic_xx] += xx(free.mass);
  to[C::kinetic_xy] += free.mass.av * n + free.mass.bv * t1;
  to[C::kinetic_yy] += free.mass.vv * n;
  to[C::velocity_x2] += xx(free.plain);
  to[C::velocity_y2] += free.plain.vv * n;
  to[C::spin] += free.spin * n;
  to[C::spin2] += free.spin2 * n;
}

}  // namespace bagnold
