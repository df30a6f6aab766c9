// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/contact_log.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

namespace bagnold::events {

std::uint64_t ContactLog::expect_end(std::uint32_t i, std::uint32_t j, Real time,
                                     Vec2<Real> const& separation, Vec2<Real> const& velocity) {
  if (!on) return 0;
  auto end = happening(false, i, j, time, separation, velocity);
  end.number = ++numbers_;
  ends_.push_back(end);
  std::push_heap(ends_.begin(), ends_.end(), std::greater<>{});
  return end.number;
}

void ContactLog::take_ends(Real until) {
  while (!ends_.empty() && ends_.front().time <= until) {
    if (cut_.erase(ends_.front().number) == 0) now_.push_back(ends_.front());
    std::pop_heap(ends_.begin(), ends_.end(), std::greater<>{});
    ends_.pop_back();
  }
}

void ContactLog::tell(Sampling const& sampling, OpenWindows& windows) {
  if (now_.empty()) return;
  std::ranges::sort(now_, {}, [](Happening const& h) {
    return std::tuple(h.event.a, h.event.b, h.time, h.event.begins);
  });
  std::vector<ContactEvent> events;
  for (auto const& one : now_) {
    auto const& event = one.event;
    bool const unseen = !events.empty() && !event.begins && events.back().begins &&
                        events.back().a == event.a && events.back().b == event.b &&
                        events.back().step == event.step;
    if (unseen)
      events.pop_back();
    else
      events.push_back(event);
  }
  now_.clear();
  windows.contacts->add(events, sampling, windows);
}

void ContactLog::shift(Real time) {
  for (auto& end : ends_) end.time -= time;
}

}  // namespace bagnold::events
