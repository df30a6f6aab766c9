// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "src/io/h5md_file.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Images of disks along frames, as in H5MD: position + image . (cell vectors) follows a disk
/// through the boundaries. Frames hold disks in the box, so each disk is assumed to move, from one
/// frame to the next, by the displacement nearest to the mean flow:
///
///     y += nearest image,    x += dgamma (y_before + y_after) / 2 + nearest image
///
/// Where the box changed, the position before is taken along with it. This is right as long as its
/// displacement relative to the mean flow stays below half the box.
class Unwrapping {
 public:
  /// Images of the next frame, zero in the first. strain: gamma of the frame.
  io::Images next(State const& state, double strain);

  /// Continues after a frame whose images are known.
  void go_on_from(State const& state, double strain, io::Images images);

  bool begun() const { return begun_; }

 private:
  bool begun_ = false;
  std::vector<std::array<double, 2>> position_;  ///< [N], of the frame before, [d_s]
  io::Images images_;                            ///< [N], of the frame before
  double strain_ = 0, length_ = 0, tilt_ = 0;    ///< of the frame before
};

}  // namespace bagnold
