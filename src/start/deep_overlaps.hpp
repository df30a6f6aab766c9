// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "src/state/state.hpp"

namespace bagnold {

/// Pairs of disks with a relative overlap 1 - r_ij/d_ij above a limit.
struct DeepOverlaps {
  std::int64_t pairs = 0;  ///< counted up to most_pairs
  double deepest = 0.0;
  std::size_t disk = 0, neighbour = 0;  ///< those that overlap most

  static constexpr std::int64_t most_pairs = 1'000'000;
};

/// Deep overlaps of all disks and their nearest images. Runs on one thread of the host, without
/// Kokkos. Values must be finite.
DeepOverlaps deep_overlaps(State const& state, double limit);

/// Largest relative overlap of all disks and their nearest images; 0 if none overlaps.
double largest_overlap(State const& state);

/// Warning on a state file whose disks overlap so much that a run would stop at once, with what to
/// do; empty if there is none.
std::string deep_overlap_warning(State const& state, std::string const& file);

}  // namespace bagnold
