// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "src/engine/events/event_state.hpp"
#include "src/engine/events/touching_group.hpp"

namespace bagnold::events {

/// Cuts a contact of two short at a time: both disks as they are there.
template <bool Rotates>
std::pair<DiskMotion<Rotates>, DiskMotion<Rotates>> cut_short(EventState<Rotates>& state,
                                                              LoneContact<Rotates> const& contact,
                                                              Real time) {
  state.sums.contact(contact, time, -1);
  state.log.cut(contact.number);
  return {state.disks.first_of(contact, time), state.disks.second_of(contact, time)};
}

/// Takes disks out of what they do at a time, into a group: what was added up for later is taken
/// back.
template <bool Rotates>
class Gathering {
 public:
  explicit Gathering(EventState<Rotates>& state) : group(state.disks.count()), s_(state) {}

  TouchingGroup<Rotates> group;

  /// A disk as it is, with all that it touches.
  void take_in(std::uint32_t disk, Real time);
  /// Both disks of a contact that is cut short.
  void take_contact(std::uint32_t k, Real time);
  /// All disks of a cluster, which is no more.
  void take_cluster(std::uint32_t k, Real time);

 private:
  EventState<Rotates>& s_;
};

extern template class Gathering<false>;
extern template class Gathering<true>;

}  // namespace bagnold::events
