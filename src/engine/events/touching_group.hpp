// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include "kernels/cpu/events/cluster.hpp"

namespace bagnold::events {

/// Disks at one time, and which of them touch: what a cluster is made of, and falls apart into.
template <bool Rotates>
class TouchingGroup {
 public:
  /// Group of at most so many disks.
  explicit TouchingGroup(std::size_t all) : place_(all) {}

  struct Disk {
    std::uint32_t disk;
    DiskMotion<Rotates> motion;
  };
  /// Disk i touches an image of another one, which was higher when the contact began.
  struct Touch {
    std::uint32_t i;
    Neighbor other;
    Real touched;  ///< since when, [tau_e]

    std::uint32_t j() const { return other.index(); }
  };
  /// Part of the group that hangs together.
  struct Part {
    std::span<Disk const> disks;
    std::span<Touch const> touches;
  };
  std::vector<Disk> disks;
  std::vector<Touch> touches;

  void clear() {
    disks.clear();
    touches.clear();
  }

  bool has(std::uint32_t disk) const {
    return std::ranges::any_of(disks, [&](Disk const& d) { return d.disk == disk; });
  }

  DiskMotion<Rotates> const& of(std::uint32_t disk) const {
    return std::ranges::find(disks, disk, &Disk::disk)->motion;
  }

  /// Falls apart into what hangs together, each with its disks and touches in order: how they came
  /// together has no part in it. Valid until the group changes.
  std::vector<Part> const& parts() {
    std::ranges::sort(disks, {}, &Disk::disk);
    std::ranges::sort(touches, {}, [](Touch const& t) { return std::tuple(t.i, t.j()); });
    join();
    ordered_disks_.clear();
    ordered_touches_.clear();
    parts_.clear();
    ordered_disks_.reserve(disks.size());
    ordered_touches_.reserve(touches.size());
    for (std::size_t a = 0; a < disks.size(); ++a)
      if (root_[a] == a) parts_.push_back(part_of(a));
    return parts_;
  }

 private:
  std::size_t place(std::uint32_t disk) const { return place_[disk]; }

  /// root_[a]: the first disk that a hangs together with.
  void join() {
    for (std::uint32_t a = 0; a < disks.size(); ++a) place_[disks[a].disk] = a;
    root_.resize(disks.size());
    std::iota(root_.begin(), root_.end(), std::size_t{0});
    auto const root_of = [&](std::size_t a) {
      while (root_[a] != a) a = root_[a] = root_[root_[a]];
      return a;
    };
    for (auto const& touch : touches) {
      auto const a = root_of(place(touch.i)), b = root_of(place(touch.j()));
      root_[std::max(a, b)] = std::min(a, b);
    }
    for (std::size_t a = 0; a < disks.size(); ++a) root_[a] = root_of(a);
  }

  Part part_of(std::size_t root) {
    auto const from = ordered_disks_.size(), first = ordered_touches_.size();
    for (std::size_t a = root; a < disks.size(); ++a)
      if (root_[a] == root) ordered_disks_.push_back(disks[a]);
    for (auto const& touch : touches)
      if (root_[place(touch.i)] == root) ordered_touches_.push_back(touch);
    return {std::span(ordered_disks_).subspan(from), std::span(ordered_touches_).subspan(first)};
  }

  std::vector<std::uint32_t> place_;  ///< [N], of a disk in `disks`
  std::vector<std::size_t> root_;
  std::vector<Disk> ordered_disks_;
  std::vector<Touch> ordered_touches_;
  std::vector<Part> parts_;
};

}  // namespace bagnold::events
