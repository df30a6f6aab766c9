// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "kernels/cpu/events/cluster.hpp"

namespace bagnold::events {

/// Disks at one time, and which of them touch: what a cluster is made of, and falls apart into.
template <bool Rotates>
struct TouchingGroup {
  struct Disk {
    std::uint32_t disk;
    DiskMotion<Rotates> motion;
  };
  /// Disk i touches the image `other` of a higher one.
  struct Touch {
    std::uint32_t i;
    Neighbor other;
    Real touched;  ///< since when, [tau_e]

    std::uint32_t j() const { return other.index(); }
  };
  std::vector<Disk> disks;
  std::vector<Touch> touches;

  bool has(std::uint32_t disk) const {
    return std::ranges::any_of(disks, [&](Disk const& d) { return d.disk == disk; });
  }

  DiskMotion<Rotates> const& of(std::uint32_t disk) const {
    return std::ranges::find(disks, disk, &Disk::disk)->motion;
  }

  /// Falls apart into what hangs together, each with its disks and touches in order: how they came
  /// together has no part in it.
  std::vector<TouchingGroup> parts() {
    std::ranges::sort(disks, {}, &Disk::disk);
    std::ranges::sort(touches, {}, [](Touch const& t) { return std::tuple(t.i, t.j()); });
    auto const place = [&](std::uint32_t disk) {
      return static_cast<std::size_t>(std::ranges::lower_bound(disks, disk, {}, &Disk::disk) -
                                      disks.begin());
    };
    std::vector<std::size_t> root(disks.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    auto const root_of = [&](std::size_t a) {
      while (root[a] != a) a = root[a] = root[root[a]];
      return a;
    };
    for (auto const& touch : touches) {
      auto const a = root_of(place(touch.i)), b = root_of(place(touch.j()));
      root[std::max(a, b)] = std::min(a, b);
    }
    std::vector<TouchingGroup> all;
    std::vector<std::size_t> part(disks.size());
    for (std::size_t a = 0; a < disks.size(); ++a) {
      auto const r = root_of(a);
      if (r == a) {
        part[a] = all.size();
        all.emplace_back();
      }
      all[part[r]].disks.push_back(disks[a]);
    }
    for (auto const& touch : touches) all[part[root_of(place(touch.i))]].touches.push_back(touch);
    return all;
  }
};

/// The image of disk i that j touches where i touches an image of j. big_i: whether i is.
inline Neighbor seen_from_other(std::uint32_t i, bool big_i, Neighbor other) {
  auto const image = other.image();
  return Neighbor::make(i, {-image.m, -image.n}, big_i);
}

}  // namespace bagnold::events
