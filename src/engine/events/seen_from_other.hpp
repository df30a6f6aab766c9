// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/box/sheared_box.hpp"

namespace bagnold::events {

/// The image of disk i that j touches where i touches an image of j. big_i: whether i is.
inline Neighbor seen_from_other(std::uint32_t i, bool big_i, Neighbor other) {
  auto const image = other.image();
  return Neighbor::make(i, {-image.m, -image.n}, big_i);
}

}  // namespace bagnold::events
