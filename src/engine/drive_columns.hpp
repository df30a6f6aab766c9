// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/physics/drives/drive_power.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Sums over the disks of a driven scene, behind the columns of SumColumns, [m d_s^2 / tau_e^3].
struct DriveColumns {
  enum : int {
    drag,  ///< power that the drag takes
    push,  ///< power that the rest of the drive gives: of a bath, its noise
    count
  };
};

inline void append(std::vector<Real>& columns, DrivePower const& power) {
  columns.push_back(power.drag);
  columns.push_back(power.push);
}

/// Columns of an engine: of SumColumns and, if there is a drive, of DriveColumns.
constexpr int engine_columns(bool rotates, bool driven) {
  return (rotates ? SumColumns::count_rotating : SumColumns::count) +
         (driven ? DriveColumns::count : 0);
}

}  // namespace bagnold
