// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold::accuracy {

/// Two disks that may touch before the list is renewed, j by one of its images.
struct NearPair {
  std::uint32_t i, j;
  Image image;           ///< of j
  std::uint8_t big = 0;  ///< how many of the two are big: d_ij = class_distance(big)
};

/// In which order pairs lie in the list: a scheme that works on pairs one after the other takes
/// them as they lie.
struct Arrangement {
  bool packs = false;  ///< eight pairs without a common disk follow one another, by class
  int tiles = 1;  ///< the box is cut into tiles x tiles blocks; pairs across an edge come first
};

/// All pairs within d_ij + skin, each once, i < j, and how many of the first lie across an edge.
struct NearPairs {
  std::vector<NearPair> pairs;
  std::size_t across = 0;
};

/// position: in the box, [d_s]; box.offset in [0, L). Kokkos must run.
NearPairs find_near_pairs(std::vector<Vec2<Real>> const& position,
                          std::vector<Species> const& species, ShearedBox const& box, Real skin,
                          Arrangement const& arrangement);

}  // namespace bagnold::accuracy
