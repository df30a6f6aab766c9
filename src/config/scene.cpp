// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/scene.hpp"

#include <cmath>
#include <numbers>

namespace bagnold {

double Scene::box_length() const {
  double const small = 0.5, big = 0.7;  // radii, [d_s]
  double const n = static_cast<double>(disks.count);
  return std::sqrt(std::numbers::pi * n * (small * small + big * big) /
                   (2 * disks.packing_fraction));
}

}  // namespace bagnold
