// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "src/engine/events/event_disks.hpp"
#include "src/engine/events/event_lists.hpp"
#include "src/engine/events/seen_from_other.hpp"

namespace bagnold::events {

/// Neighbours that the disks of clusters may touch while both keep to their corridors, or to
/// their lines: a bit an entry of its row in the lists, the last one for all that are left.
class NearPairs {
 public:
  explicit NearPairs(std::size_t disks) : bits_(disks) {}

  void clear(std::uint32_t i) { bits_[i] = 0; }

  /// Entry k of the row of disk i.
  void add(std::uint32_t i, std::uint32_t k) { bits_[i] |= std::uint64_t{1} << std::min(k, last); }

  /// The pair of i with n, in the row of n.
  template <bool Rotates>
  void add_seen_from(EventDisks<Rotates> const& disks, EventLists const& lists, std::uint32_t i,
                     Neighbor n) {
    auto const j = n.index();
    auto const reverse = seen_from_other(i, disks.path[i].species != 0, n);
    auto const* const row = lists.entries() + lists.begin(j);
    auto const count = lists.end(j) - lists.begin(j);
    for (std::uint32_t k = 0; k < count; ++k)
      if (row[k].packed == reverse.packed) return add(j, k);
  }

  /// with(k) for the entries of a row that has `count`, in their order.
  template <class With>
  void for_each(std::uint32_t i, std::uint32_t count, With const& with) const {
    for (auto left = bits_[i]; left != 0; left &= left - 1) {
      auto const k = static_cast<std::uint32_t>(std::countr_zero(left));
      if (k < last) {
        with(k);
      } else {
        for (auto rest = last; rest < count; ++rest) with(rest);
      }
    }
  }

 private:
  static constexpr std::uint32_t last = 63;

  std::vector<std::uint64_t> bits_;  ///< [N]
};

}  // namespace bagnold::events
