// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold::quasi_static {

/// Disk i and an image of disk j, i < j, that may touch before the list is renewed.
struct NearPair {
  std::uint32_t i, j;
  Image image;
  Real distance;  ///< d_ij, [d_s]

  /// r_ij, [d_s]
  Vec2<Real> separation(std::vector<Vec2<Real>> const& position, ShearedBox const& box) const {
    return (position[i] - position[j]) - box.shift(image);
  }
};

/// All pairs within d_ij + skin, by i and then by j. position: in the box, whose offset is in
/// [0, L_x).
std::vector<NearPair> near_pairs(std::vector<Vec2<Real>> const& position,
                                 std::vector<Species> const& species, SpeciesTable const& table,
                                 ShearedBox const& box, Real skin);

}  // namespace bagnold::quasi_static
