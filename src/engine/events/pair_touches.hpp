// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/events/event_disks.hpp"

namespace bagnold::events {

/// When two disks touch, by their two paths alone.
template <bool Rotates>
class PairTouches {
 public:
  explicit PairTouches(EventDisks<Rotates> const& disks) : disks_(&disks) {}

  /// Time at which two touch that may do so before both are on their lines. A disk of a cluster has
  /// a path to the end of its step.
  Real touch(std::uint32_t i, Neighbor n) const;

  /// True if a disk of a cluster and a mate, or one that flies, cannot touch in its step.
  bool stays_apart(Cluster<Rotates> const& cluster, Member<Rotates> const& m, Neighbor n,
                   bool mate) const;

 private:
  LinePair lines(std::uint32_t i, Neighbor n) const;
  Real gap_closes(std::uint32_t i, Neighbor n, Real from, Real until) const;

  EventDisks<Rotates> const* disks_;
};

extern template class PairTouches<false>;
extern template class PairTouches<true>;

}  // namespace bagnold::events
