// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/physics/species.hpp"
#include "src/config/names.hpp"

namespace bagnold {

bool Scene::rotates() const {
  auto const rotating = rotating_models();
  return std::ranges::find(rotating, disks.model) != rotating.end();
}

double Scene::box_length() const {
  double const small = small_diameter / 2, big = big_diameter / 2;
  double const n = static_cast<double>(disks.count);
  return std::sqrt(std::numbers::pi * n * (small * small + big * big) /
                   (2 * disks.packing_fraction * disks.box_aspect));
}

}  // namespace bagnold
