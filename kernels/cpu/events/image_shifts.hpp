// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/box/sheared_box.hpp"

namespace bagnold::events {

/// Where an image is from its disk.
struct ImageShift {
  Vec2<Real> place;  ///< at time 0, [d_s]
  Real velocity;     ///< along x, [d_s / tau_e]

  Vec2<Real> at(Real time) const { return {place.x + velocity * time, place.y}; }
};

/// The shifts of all images of the neighbours in a list, while it lasts.
class ImageShifts {
 public:
  ImageShifts() = default;

  /// box: when the list is built, time 0.
  explicit ImageShifts(ShearedBox const& box) {
    for (int n = -1; n <= 1; ++n)
      for (int m = -2; m <= 2; ++m) {
        Image const image{m, n};
        of_[code(Neighbor::make(0, image))] = {box.shift(image), box.velocity_shift(image)};
      }
  }

  ImageShift const& operator()(Neighbor neighbor) const { return of_[code(neighbor)]; }

 private:
  static std::uint32_t code(Neighbor neighbor) { return neighbor.packed & 15u; }

  ImageShift of_[16] = {};
};

}  // namespace bagnold::events
