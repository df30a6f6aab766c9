// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "kernels/cpu/islands/islands.hpp"
#include "kernels/cpu/steps/block_stepper.hpp"

namespace bagnold {

/// Results of one lookahead for the disks that meet others.
struct MeetingResults {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Unit of work: a pair of disks, or a batch of larger islands.
  struct Unit {
    std::size_t first_pair, end_pair;  ///< in `pairs`
    std::size_t sums;                  ///< its first in `sums`
    bool batch;
    bool alive = true;  ///< false: done again with more pairs
    Real touching = 0;  ///< pairs in a batch, mean over steps
  };
  struct Disk {
    std::uint32_t slot, unit;
    Image image;
    simd::Record record;  ///< at the end of the lookahead
    Real spin;
    Real deviation;  ///< largest, from its straight flight, [d_s]
  };

  std::vector<std::uint32_t> disk_of;  ///< by slot: its place in `disks`, or none
  std::vector<Disk> disks;
  std::vector<Unit> units;
  std::vector<SlotPair> pairs;  ///< of all units
  std::vector<BlockSums> sums;  ///< a measurement window each, for every unit

  void forget() {
    for (auto const& disk : disks) disk_of[disk.slot] = none;
    disks.clear();
    units.clear();
    pairs.clear();
    sums.clear();
  }

  bool has(std::uint32_t slot) const { return disk_of[slot] != none; }
  Disk& of(std::uint32_t slot) { return disks[disk_of[slot]]; }
  Disk const& of(std::uint32_t slot) const { return disks[disk_of[slot]]; }
  Real deviation(std::uint32_t slot) const { return has(slot) ? of(slot).deviation : 0; }

  Real largest_deviation() const {
    Real largest = 0;
    for (auto const& disk : disks) largest = std::max(largest, disk.deviation);
    return largest;
  }

  /// bins: measurement windows.
  Unit& add_unit(bool batch, std::size_t bins) {
    units.push_back({pairs.size(), pairs.size(), sums.size(), batch});
    sums.resize(sums.size() + bins);
    return units.back();
  }

  /// Adds a disk to the last unit.
  void add_disk(Islands::Disk const& disk) {
    if (disk_of[disk.slot] == none) {
      disk_of[disk.slot] = static_cast<std::uint32_t>(disks.size());
      disks.push_back({});
    }
    auto& result = of(disk.slot);
    result.slot = disk.slot;
    result.image = disk.image;
    result.unit = static_cast<std::uint32_t>(units.size() - 1);
  }

  /// Adds a pair to the last unit.
  void add_pair(Islands const& islands, Islands::Pair const& pair) {
    auto const &a = islands.disks[pair.a], &b = islands.disks[pair.b];
    pairs.push_back(
        {a.slot, Neighbor::make(b.slot, {b.image.m - a.image.m, b.image.n - a.image.n})});
    units.back().end_pair = pairs.size();
  }
};

}  // namespace bagnold
