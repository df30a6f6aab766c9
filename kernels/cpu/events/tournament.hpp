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
/// comparisons, without a branch that depends on them. Of equal times that of the lowest slot is
/// first.
class Tournament {
 public:
  explicit Tournament(std::uint32_t slots)
      : leaves_(std::bit_ceil(slots < 2 ? 2u : slots)), node_(2 * std::size_t{leaves_}) {
    for (std::uint32_t s = 0; s < leaves_; ++s) node_[leaves_ + s] = {never, s};
    for (std::uint32_t k = leaves_ - 1; k > 0; --k) node_[k] = node_[2 * k];
  }

  void set(std::uint32_t slot, Real time) {
    Node* const node = node_.data();
    auto k = leaves_ + slot;
    Node winner{time, slot};
    for (node[k] = winner; k > 1; node[k] = winner) {
      Node const other = node[k ^ 1];
      auto const loses = static_cast<std::uint64_t>(other.time < winner.time) |
                         (static_cast<std::uint64_t>(other.time == winner.time) &
                          static_cast<std::uint64_t>(other.slot < winner.slot));
      auto const mask = ~loses + 1;  // a choice that is no branch
      winner.slot ^= (winner.slot ^ other.slot) & mask;
      winner.time =
          std::bit_cast<Real>(bits(winner.time) ^ ((bits(winner.time) ^ bits(other.time)) & mask));
      k >>= 1;
    }
  }

  std::uint32_t first() const { return static_cast<std::uint32_t>(node_[1].slot); }
  Real time(std::uint32_t slot) const { return node_[leaves_ + slot].time; }

 private:
  /// A slot, or the first one of a subtree.
  struct Node {
    Real time;
    std::uint64_t slot;
  };

  static std::uint64_t bits(Real time) { return std::bit_cast<std::uint64_t>(time); }

  std::uint32_t leaves_;
  std::vector<Node> node_;  ///< [2 leaves], its root at 1
};

}  // namespace bagnold::events
