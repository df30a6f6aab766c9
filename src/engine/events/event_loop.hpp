// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/engine/events/touch_events.hpp"

namespace bagnold::events {

/// Takes event after event, in the order of time.
template <bool Rotates>
class EventLoop {
 public:
  explicit EventLoop(EventState<Rotates>& state) : touches(state), s_(state) {}

  TouchEvents<Rotates> touches;

  /// Does what happens up to a time, or to the end of the step at which the lists are to be built.
  void run(Real until);

  /// Predicts the next event of a disk, or of the cluster whose event it has.
  void predict(std::uint32_t slot);
  void predict_all();

  /// Time goes back to before disks left their reach.
  void watch_again() {
    for (auto const slot : left_) predict(slot);
    left_.clear();
  }

  /// Has no event of its own: its cluster has one.
  bool follows(std::uint32_t i) const {
    auto const& disks = s_.disks;
    return disks.path[i].manner == Manner::cluster && disks.clusters[disks.touching[i]].slot() != i;
  }

 private:
  EventState<Rotates>& s_;
  std::vector<std::uint32_t> left_;  ///< since the last build, or since they were watched again
};

extern template class EventLoop<false>;
extern template class EventLoop<true>;

}  // namespace bagnold::events
