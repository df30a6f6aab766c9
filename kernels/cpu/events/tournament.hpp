// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernels/physics/vec2.hpp"

namespace bagnold::events {

inline constexpr Real never = std::numeric_limits<Real>::infinity();

/// The earliest of a fixed number of times, as a tree of winners of four each: a change costs
/// log4 n comparisons, without a branch that depends on them, and a line of memory each. Of equal
/// times that of the lowest slot is first.
class Tournament {
 public:
  explicit Tournament(std::uint32_t slots) {
    auto count = std::max(slots, 1u);
    times_.resize((count + 3) / 4);
    for (count = (count + 3) / 4; count > 1;) {
      count = (count + 3) / 4;
      level_.push_back(static_cast<std::uint32_t>(nodes_.size()));
      nodes_.resize(nodes_.size() + count);
    }
  }

  void set(std::uint32_t slot, Real time) {
    auto k = slot >> 2;
    auto child = slot & 3u;
    Four& four = times_[k];
    four.time[child] = time;
    Winner winner{time, slot};
    play(winner, child, [&](std::uint32_t c) { return Winner{four.time[c], 4 * k + c}; });
    for (auto const level : level_) {
      child = k & 3u;
      k >>= 2;
      Node& node = nodes_[level + k];
      node.time[child] = winner.time;
      node.slot[child] = static_cast<std::uint32_t>(winner.slot);
      play(winner, child, [&](std::uint32_t c) { return Winner{node.time[c], node.slot[c]}; });
    }
    first_ = winner;
  }

  std::uint32_t first() const { return static_cast<std::uint32_t>(first_.slot); }
  Real first_time() const { return first_.time; }
  Real time(std::uint32_t slot) const { return times_[slot >> 2].time[slot & 3u]; }

 private:
  struct Winner {
    Real time;
    std::uint64_t slot;
  };
  struct alignas(32) Four {
    Real time[4] = {never, never, never, never};
  };
  struct alignas(64) Node {
    Real time[4] = {never, never, never, never};
    std::uint32_t slot[4] = {};
  };

  /// Plays the child that has changed against the three others, which meet before it is known.
  template <class Of>
  static void play(Winner& winner, std::uint32_t child, Of const& of) {
    Winner best = of(child == 0 ? 1 : 0);
    for (std::uint32_t c = 1; c < 3; ++c) {
      Winner const next = of(c + (child <= c ? 1 : 0));
      take(best, next, static_cast<std::uint64_t>(next.time < best.time));
    }
    take(winner, best,
         static_cast<std::uint64_t>(best.time < winner.time) |
             (static_cast<std::uint64_t>(best.time == winner.time) &
              static_cast<std::uint64_t>(best.slot < winner.slot)));
  }

  /// The other one, if it wins: a choice that is no branch.
  static void take(Winner& winner, Winner const& other, std::uint64_t wins) {
    auto const mask = ~wins + 1;
    winner.slot ^= (winner.slot ^ other.slot) & mask;
    winner.time =
        std::bit_cast<Real>(bits(winner.time) ^ ((bits(winner.time) ^ bits(other.time)) & mask));
  }

  static std::uint64_t bits(Real time) { return std::bit_cast<std::uint64_t>(time); }

  std::vector<Four> times_;           ///< by slot
  std::vector<Node> nodes_;           ///< above them, the root last
  std::vector<std::uint32_t> level_;  ///< where each begins
  Winner first_{never, 0};
};

}  // namespace bagnold::events
