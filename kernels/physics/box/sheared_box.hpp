// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/math.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Periodic image of a disk: the one at (x + m L_x + n gamma L_y, y + n L_y).
///
/// m in -2..2 and n in -1..1 while disks are in the box at a list build, so 15 images: 4 bits.
struct Image {
  int m = 0;
  int n = 0;
};

/// The box under Lees-Edwards shear at one instant (P1 Sec. II A, P2 Sec. II A), where square
/// L_x = L_y = L.
struct ShearedBox {
  Real length;           ///< L_x, [d_s]
  Real offset;           ///< gamma L_y, [d_s]; in [0, L_x) at a list build, grows to the next
  Real strain_rate;      ///< gammadot, [1 / tau_e]
  Real height = length;  ///< L_y, [d_s]

  /// Displacement of an image from its disk, [d_s].
  KOKKOS_FUNCTION Vec2<Real> shift(Image const& image) const {
    return {image.m * length + image.n * offset, image.n * height};
  }

  /// v_x of an image relative to its disk: n gammadot L_y, [d_s / tau_e].
  KOKKOS_FUNCTION Real velocity_shift(Image const& image) const {
    return image.n * (strain_rate * height);
  }
};

/// Wraps a disk back into [0, L_x) x [0, L_y). A wrap in y changes x by the offset, v_x by gammadot
/// L_y.
///
/// Positions that are in the box already keep their bits.
KOKKOS_INLINE_FUNCTION void wrap(ShearedBox const& box, Vec2<Real>& position, Real& velocity_x) {
  Real const n = math::floor(position.y / box.height);
  if (n != 0) {
    position.y -= n * box.height;
    position.x -= n * box.offset;
    velocity_x -= n * (box.strain_rate * box.height);
  }
  Real const m = math::floor(position.x / box.length);
  if (m != 0) position.x -= m * box.length;
}

/// A neighbour of a disk: index, size and image in one word, which is ordered by the index.
struct Neighbor {
  std::uint32_t packed;

  static constexpr std::uint32_t max_count = 1u << 27;

  KOKKOS_FUNCTION static Neighbor make(std::uint32_t index, Image const& image, bool big = false) {
    return {(index << 5) | (static_cast<std::uint32_t>(big) << 4) |
            static_cast<std::uint32_t>((image.n + 1) * 5 + (image.m + 2))};
  }
  KOKKOS_FUNCTION std::uint32_t index() const { return packed >> 5; }
  KOKKOS_FUNCTION bool big() const { return (packed & 16u) != 0; }
  KOKKOS_FUNCTION Image image() const {
    int const code = static_cast<int>(packed & 15u);
    int const row = code / 5;
    return {code - 5 * row - 2, row - 1};
  }
};

}  // namespace bagnold
