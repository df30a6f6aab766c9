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
        auto const k = code(Neighbor::make(0, image));
        of_[k] = {box.shift(image), box.velocity_shift(image)};
        row_[k] = {{of_[k].place.x, of_[k].place.y, of_[k].velocity}};
      }
  }

  ImageShift const& operator()(Neighbor neighbor) const { return of_[code(neighbor)]; }

  /// As a Path has it.
  double const* row(Neighbor neighbor) const { return row_[code(neighbor)].x; }

 private:
  static std::uint32_t code(Neighbor neighbor) { return neighbor.packed & 15u; }

  struct alignas(64) Row {
    double x[8];
  };

  ImageShift of_[16] = {};
  Row row_[16] = {};
};

}  // namespace bagnold::events
