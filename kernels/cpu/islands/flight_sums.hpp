// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/islands/sample_times.hpp"
#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/in_time.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Sums of one configuration; sums of spins are zero for laws without them.
using BlockSums = Sums<true>;

/// u_x = v_x - gammadot y of a disk in free flight from y at t = 0.
template <class T>
BAGNOLD_INLINE Linear<T> flight_x(T const& velocity_x, T const& y, T const& velocity_y,
                                  Real strain_rate) {
  return {{peculiar_x(velocity_x, y, strain_rate), T(-strain_rate) * velocity_y}};
}

/// Sum over the sample times that multiplies a constant in a column: sum of q for the linear column
/// `spin`, the number of samples otherwise.
BAGNOLD_INLINE Real const& constant_power(SampleTimes::Powers const& powers, int column) {
  return column == SumColumns::spin ? powers.linear : powers.n;
}

/// Adds polynomials in time to columns: each by its sum over the times of `powers`, multiplied by
/// `weight`.
struct SumsAtTimes {
  BlockSums& sums;
  SampleTimes::Powers const& powers;
  Real weight;

  struct Column {
    Real& sum;
    SumsAtTimes const& at;
    Real const& n;

    template <int degree>
    BAGNOLD_INLINE void operator+=(InTime<Real, degree> const& value) const {
      sum += at.weight * value.over(n, at.powers.t1, at.powers.t2);
    }
    BAGNOLD_INLINE void operator+=(Real value) const { *this += InTime<Real, 0>{{value}}; }
  };

  BAGNOLD_INLINE Column operator[](int column) const {
    return {sums.value[column], *this, constant_power(powers, column)};
  }
};

/// Sums of disks in free flight, as polynomials in time: the columns that add_motion() and
/// add_spin() add to.
struct FlightSums {
  Quadratic<Real> column[SumColumns::count_rotating];

  FlightSums& operator+=(FlightSums const& o) {
    for (int c = pair_columns; c < SumColumns::count_rotating; ++c) column[c] += o.column[c];
    return *this;
  }

  /// Adds the sums over the times of `powers`, multiplied by `weight`.
  void add_to(BlockSums& sums, SampleTimes::Powers const& powers, Real weight = 1) const {
    for (int c = pair_columns; c < SumColumns::count_rotating; ++c)
      sums.value[c] += weight * column[c].over(constant_power(powers, c), powers.t1, powers.t2);
  }
};

}  // namespace bagnold
