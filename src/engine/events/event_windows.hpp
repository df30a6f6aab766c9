// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "src/engine/events/event_state.hpp"

namespace bagnold::events {

/// Where windows of measurement begin and end in what disks do.
template <bool Rotates>
class EventWindows {
 public:
  explicit EventWindows(EventState<Rotates>& state) : s_(state) {}

  /// A window begins: all from then on is added to these columns.
  void begin(Real* columns, Real time);
  /// It goes on in these.
  void resume(Real* columns, Real begun) { s_.sums.begin(columns, begun); }
  /// It ends: all before that is in it, and nothing of what lies ahead.
  void end(Real time);

 private:
  void add_ahead(Real time, Real sign);

  EventState<Rotates>& s_;
};

extern template class EventWindows<false>;
extern template class EventWindows<true>;

using TouchingPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// All that touch at a time that has been reached, i < j.
template <bool Rotates>
TouchingPairs who_touches(EventDisks<Rotates> const& disks, Real time);

}  // namespace bagnold::events
