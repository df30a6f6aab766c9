// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>

#include "kernels/cpu/simd/pack.hpp"
#include "kernels/physics/vec2.hpp"

/// Transfer of disks to and from packs. A record of four numbers a disk fills half a cache line, so
/// a pair costs two loads.
namespace bagnold::simd {

struct alignas(32) Record {
  double x, y;    ///< [d_s]
  double vx, vy;  ///< lab frame, [d_s / tau_e]
};

/// A pack of records, component by component.
struct Records {
  Pack x, y, vx, vy;

  Vec2<Pack> position() const { return {x, y}; }
  Vec2<Pack> velocity() const { return {vx, vy}; }
};

BAGNOLD_INLINE Records make_records(Vec2<Pack> const& position, Vec2<Pack> const& velocity) {
  return {position.x, position.y, velocity.x, velocity.y};
}

/// Two local indices in one word, multiplied by four so that they address a record without a shift.
struct LocalPair {
  std::uint16_t a4, b4;

  static constexpr std::uint32_t max_count = 1u << 14;

  static LocalPair make(std::uint32_t a, std::uint32_t b) {
    return {static_cast<std::uint16_t>(4 * a), static_cast<std::uint16_t>(4 * b)};
  }
  std::uint32_t a() const { return a4 / 4u; }
  std::uint32_t b() const { return b4 / 4u; }
};

/// Array element of a quadrupled index.
template <class T>
T& at(T* array, std::uint16_t index4) {
  static_assert(sizeof(T) % 4 == 0);
  using Byte = std::conditional_t<std::is_const_v<T>, char const, char>;
  return *reinterpret_cast<T*>(reinterpret_cast<Byte*>(array) +
                               sizeof(T) / 4 * std::size_t(index4));
}

/// Force on a disk of a law without rotation.
struct alignas(16) Force {
  double x, y;  ///< [m d_s / tau_e^2]
};

/// Force on a disk of a law with rotation; `torque` is over the diameter. The order suits addsub:
/// components that are opposite on the partner are in even places.
struct alignas(32) TurningForce {
  double x, count, y, torque_per_diameter;  ///< count: of contacts, if asked for
};

/// Forces on a pack of disks, component by component.
struct ForceComponents {
  Pack x, y, torque_per_diameter, count;

  Vec2<Pack> force() const { return {x, y}; }
};

}  // namespace bagnold::simd
