// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "kernels/physics/sums/sums.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Sums over the disks whose centre lies in a slice of y; only `area` is cut at the edges of the
/// slice. w = v_x - gammadot y does not change when a disk crosses the edge of the box in y; h is
/// the distance from the middle of the slice.
struct SliceColumns {
  enum : int {
    area,  ///< of disks within the slice, wherever their centres are, [d_s^2]
    disks,
    mass,        ///< sum m
    height,      ///< sum m h
    height2,     ///< sum m h^2
    flow_x,      ///< sum m w
    flow_y,      ///< sum m v_y
    shear_x,     ///< sum m h w
    shear_y,     ///< sum m h v_y
    kinetic_xx,  ///< sum m w^2
    kinetic_xy,  ///< sum m w v_y
    kinetic_yy,  ///< sum m v_y^2
    spin,        ///< sum thetadot, [1/tau_e]
    elastic_xx,  ///< these as in SumColumns: half of each pair to either disk
    elastic_xy,
    elastic_yy,
    dissipative_xx,
    dissipative_xy,
    dissipative_yx,
    dissipative_yy,
    contacts,
    count
  };
};

/// Equal slices of the box in y: as many as are at least 1.5 d_s thick, and at least 8.
struct Slices {
  double width;   ///< L_x, [d_s]
  double height;  ///< L_y, [d_s]
  std::size_t n;

  Slices(double width, double height);

  double thickness() const { return height / static_cast<double>(n); }
  double middle(std::size_t slice) const {
    return (static_cast<double>(slice) + 0.5) * thickness();
  }
};

/// Columns of every slice, [n][SliceColumns::count]; slice 0 begins at y = origin, in 0 .. L_y.
/// mass: [N]; stress: from disk_stress(), [N].
std::vector<double> slice_sums(Slices const& slices, State const& state,
                               std::vector<double> const& mass,
                               std::vector<Sums<false>> const& stress, double origin);

}  // namespace bagnold
