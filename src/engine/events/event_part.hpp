// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "src/engine/events/event_lists.hpp"

namespace bagnold::events {

/// Disks that go alone for a while: some that are near each other in memory, and a halo.
///
/// Indices in the part are in the order of those in the whole, on which the order of events at one
/// time depends.
struct Part {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t first, count;            ///< own disks, in the whole
  int depth;                             ///< of the halo
  std::uint32_t own_first = 0;           ///< in the part
  std::vector<std::uint32_t> of_whole;   ///< all of them, ascending
  std::vector<std::uint32_t> neighbors;  ///< in the lists of own disks, but not own; in the part

  /// Index in the part of a disk of the whole, or none.
  std::uint32_t place(std::uint32_t disk) const {
    if (disk - first < count) return own_first + (disk - first);
    auto const found = std::ranges::lower_bound(of_whole, disk);
    return found == of_whole.end() || *found != disk
               ? none
               : static_cast<std::uint32_t>(found - of_whole.begin());
  }
  std::uint32_t in_whole(std::uint32_t k) const { return k == none ? none : of_whole[k]; }
};

/// The part of these own disks, with all in lists of lists of them, `depth` times.
Part make_part(EventLists const& lists, std::uint32_t first, std::uint32_t count, int depth);

}  // namespace bagnold::events
