// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/state/state.hpp"

namespace bagnold {

/// Local packing fraction and strain rate of each disk, over a circle of radius R = 4 d_s about its
/// centre (P2 Fig. 27).
struct LocalFields {
  /// [N]: area of disks in the circle, cut at its rim, over pi R^2. Overlaps of two disks count
  /// twice.
  std::vector<double> packing_fraction;
  /// [N], [1/tau_e]: slope in y of the plane that fits v_x best (least squares, in x and y) of all
  /// disks that overlap the circle, each weighted by its area in it; NaN if fewer than three disks,
  /// or disks on a line, do not determine it.
  std::vector<double> strain_rate;
};

/// state: in the box, which is at least least_box_for_fields() wide.
LocalFields local_fields(State const& state);

}  // namespace bagnold
