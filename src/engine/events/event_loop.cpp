// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_loop.hpp"

#include <algorithm>

namespace bagnold::events {

template <bool Rotates>
void EventLoop<Rotates>::run(Real until) {
  auto const& times = s_.queue.times;
  Real& now = s_.disks.now;
  while (!s_.too_deep) {
    auto const slot = times.first();
    Real const time = times.first_time();
    if (time > until || time > s_.build_time()) break;
    now = std::max(now, time);
    Event const event = s_.queue.event[slot];
    switch (event.kind) {
      case Event::Kind::leave:
        s_.ask_for_build(slot, now);
        s_.predictions.of_disk(slot, false);
        left_.push_back(slot);
        break;
      case Event::Kind::end:
        touches.end_step(s_.disks.touching[slot]);
        break;
      case Event::Kind::touch:
        if (s_.disks.path[event.other.index()].changes == event.changes)
          touches.touch(event.disk, event.other, time);
        else
          predict(slot);
    }
  }
}

template <bool Rotates>
void EventLoop<Rotates>::predict(std::uint32_t slot) {
  if (s_.disks.path[slot].manner == Manner::cluster)
    s_.predictions.of_cluster(s_.disks.touching[slot]);
  else
    s_.predictions.of_disk(slot);
}

template <bool Rotates>
void EventLoop<Rotates>::predict_all() {
  auto const& disks = s_.disks;
  left_.clear();
  for (std::uint32_t i = 0; i < disks.count(); ++i)
    if (disks.path[i].manner == Manner::cluster) s_.predictions.find_near(i);
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    if (follows(i))
      s_.queue.set(i, never, {i});
    else
      predict(i);
  }
}

template class EventLoop<false>;
template class EventLoop<true>;

}  // namespace bagnold::events
