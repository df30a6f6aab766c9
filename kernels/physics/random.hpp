// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <cstdint>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Uses of random numbers while a system is stepped. Each has its own stream for each seed and does
/// not depend on what the others draw. The number of a stream enters the numbers drawn: append,
/// never renumber.
enum class Stream : std::uint64_t {
  contact_samples = 0,  ///< which configurations of a contact are sampled
  thermal_noise = 1     ///< forces of a bath
};

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): a hash of 64 bits.
KOKKOS_INLINE_FUNCTION constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

struct Centred {
  Real x, y, z;
};

/// Random numbers by their purpose: of a disk or pair, at a step. They have no state, so bits
/// depend neither on threads nor on restarts.
struct RandomStream {
  std::uint64_t key;

  KOKKOS_INLINE_FUNCTION constexpr RandomStream(Stream stream, std::uint64_t seed)
      : key(mixed(seed ^ static_cast<std::uint64_t>(stream) << 60)) {}

  KOKKOS_INLINE_FUNCTION constexpr std::uint64_t bits(std::uint64_t whose,
                                                      std::uint64_t when) const {
    return mixed(mixed(key ^ whose) ^ when);
  }

  /// Uniform in (0, 1], with 53 bits.
  KOKKOS_INLINE_FUNCTION constexpr Real uniform(std::uint64_t whose, std::uint64_t when) const {
    return static_cast<Real>((bits(whose, when) >> 11) + 1) * (1 / Real(std::uint64_t{1} << 53));
  }

  /// Three numbers, uniform in (-1/2, 1/2), of 21 bits each, with mean 0.
  KOKKOS_INLINE_FUNCTION constexpr Centred centred(std::uint64_t whose, std::uint64_t when) const {
    auto const all = bits(whose, when);
    auto const one = [all](int shift) {
      auto const k = static_cast<Real>(all >> shift & 0x1fffff);
      return (k + Real(0.5)) * (1 / Real(1 << 21)) - Real(0.5);
    };
    return {one(1), one(22), one(43)};
  }
};

}  // namespace bagnold
