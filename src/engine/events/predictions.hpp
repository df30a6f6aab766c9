// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/engine/events/event_disks.hpp"
#include "src/engine/events/event_lists.hpp"
#include "src/engine/events/near_pairs.hpp"
#include "src/engine/events/pair_touches.hpp"

namespace bagnold::events {

/// Next event of a disk, or of a cluster.
struct Event {
  enum class Kind : std::uint8_t {
    touch,  ///< disk touches a neighbour
    leave,  ///< it leaves its reach: the lists are to be built
    end     ///< the step of the cluster ends
  };
  std::uint32_t disk = 0;
  Neighbor other{};           ///< the neighbour
  std::uint32_t changes = 0;  ///< of its path, when this was predicted
  Kind kind = Kind::leave;
};

/// The next event of each disk or cluster, in the order of time, then of slots: a disk has its own,
/// a cluster that of its first disk.
struct EventQueue {
  explicit EventQueue(std::uint32_t disks) : times(disks), event(disks) {}

  void set(std::uint32_t slot, Real time, Event const& of) {
    event[slot] = of;
    times.set(slot, time);
  }

  /// Nothing happens to a disk alone: its cluster has an event.
  void clear(std::uint32_t slot) {
    event[slot] = {slot};
    if (times.time(slot) < never) times.set(slot, never);
  }

  Tournament times;
  std::vector<Event> event;
};

/// Predicts touches from the paths of disks.
///
/// When two disks touch depends on their two paths alone, and not on when it is asked for: both are
/// followed from the younger path's begin on. So predictions may be made anew at any time, and a
/// restarted run finds the bits of one that went on.
template <bool Rotates>
class Predictions {
 public:
  Predictions(EventDisks<Rotates> const& disks, EventLists const& lists, EventQueue& queue)
      : disks_(&disks), lists_(&lists), queue_(&queue), pairs_(disks), near_(disks.count()) {}

  /// watched: whether the disk is told to leave its reach.
  void of_disk(std::uint32_t i, bool watched = true);
  void of_cluster(std::uint32_t k);

  /// Whom a disk of a cluster may touch in its corridor.
  void find_near(std::uint32_t i);

 private:
  EventDisks<Rotates> const* disks_;
  EventLists const* lists_;
  EventQueue* queue_;
  PairTouches<Rotates> pairs_;
  NearPairs near_;
};

extern template class Predictions<false>;
extern template class Predictions<true>;

}  // namespace bagnold::events
