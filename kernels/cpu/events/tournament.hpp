// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernels/physics/vec2.hpp"

namespace bagnold::events {

inline constexpr Real never = std::numeric_limits<Real>::infinity();

/// The earliest of a fixed number of times, as a tree of winners: a change costs log2 n
/// comparisons. Of equal times that of the lowest slot is first.
class Tournament {
 public:
  explicit Tournament(std::uint32_t slots)
      : leaves_(std::bit_ceil(slots < 2 ? 2u : slots)),
        time_(leaves_, never),
        winner_(2 * std::size_t{leaves_}) {
    for (std::uint32_t s = 0; s < leaves_; ++s) winner_[leaves_ + s] = s;
    for (std::uint32_t k = leaves_ - 1; k > 0; --k) play(k);
  }

  void set(std::uint32_t slot, Real time) {
    time_[slot] = time;
    for (std::uint32_t k = (leaves_ + slot) >> 1; k > 0; k >>= 1) play(k);
  }

  std::uint32_t first() const { return winner_[1]; }
  Real time(std::uint32_t slot) const { return time_[slot]; }

 private:
  void play(std::uint32_t k) {
    auto const a = winner_[2 * k], b = winner_[2 * k + 1];
    winner_[k] = time_[a] <= time_[b] ? a : b;
  }

  std::uint32_t leaves_;
  std::vector<Real> time_;             ///< [leaves]
  std::vector<std::uint32_t> winner_;  ///< [2 leaves], of the subtree; its root at 1
};

}  // namespace bagnold::events
