// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/physics/sums/sums.hpp"
#include "src/engine/drive_columns.hpp"

namespace bagnold {

/// Columns of a controlled run, behind those of its engine: what changes from piece to piece.
struct ControlColumns {
  enum : int {
    strain_rate,       ///< gammadot, [1 / tau_e]
    packing_fraction,  ///< phi
    kinetic,           ///< sum m (dv_x^2 + dv_y^2)/2, which the box does not scale
    count
  };
};

/// A piece of a controlled run.
struct ControlledPiece {
  double strain_rate;       ///< [1/tau_e]
  double packing_fraction;  ///< of the scene
  double length;            ///< L_x over that of the scene
};

/// Adds ControlColumns to the sums of a piece. Sums of the pressure tensor and of powers, that of
/// torques and of a drive included, become those of a box as large as the scene's at the same
/// densities, so that they add up over boxes.
inline void append_control(std::vector<double>& sums, double weight, ControlledPiece const& piece,
                           bool rotates, bool driven) {
  using C = SumColumns;
  double const area = piece.length * piece.length;
  double const kinetic = (sums[C::kinetic_xx] + sums[C::kinetic_yy]) / 2;
  for (int c = 0; c <= C::kinetic_yy; ++c) sums[static_cast<std::size_t>(c)] /= area;
  if (rotates) sums[C::torque_power] /= area;
  auto const drive = static_cast<std::size_t>(engine_columns(rotates, false));
  for (std::size_t c = 0; driven && c < DriveColumns::count; ++c) sums[drive + c] /= area;
  sums.insert(sums.end(),
              {weight * piece.strain_rate, weight * piece.packing_fraction / area, kinetic});
}

}  // namespace bagnold
