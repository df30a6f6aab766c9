// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/engine/events/event_state.hpp"

namespace bagnold::events {

/// Where windows of measurement begin and end in what disks do.
template <bool Rotates>
class EventWindows {
 public:
  explicit EventWindows(EventState<Rotates>& state) : s_(state) {}

  /// A window begins: all from then on is added up.
  void begin(Real time);
  /// It goes on. begun: when it began, in the times of now.
  void resume(Real begun) { s_.sums.begin(begun); }

  /// The window under way began at a step of the run: what rates it has had up to another one.
  void recall_rates(std::int64_t begun, std::int64_t step);
  /// At that step it has the present rate.
  void add_rate(std::int64_t begun, std::int64_t step) {
    s_.sums.speeds().add(s_.times.between(begun, step), s_.times.speed());
  }
  /// It ends: all before that is added to these columns, and nothing of what lies ahead.
  void end(Real time, Real* columns);

 private:
  void add_ahead(Real time, Real sign);

  EventState<Rotates>& s_;
};

extern template class EventWindows<false>;
extern template class EventWindows<true>;

/// A contact at a time.
template <bool Rotates>
struct TouchingPair {
  std::uint32_t i, j;          ///< names of the disks, i < j
  PairMotion<Rotates> motion;  ///< of one against the other
  Real spin;                   ///< see contact_velocities
};

/// All that touch at a time that has been reached, with their motion.
template <bool Rotates>
std::vector<TouchingPair<Rotates>> touching_pairs(EventState<Rotates> const& state, Real time);

}  // namespace bagnold::events
