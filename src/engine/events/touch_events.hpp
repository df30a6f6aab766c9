// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/engine/events/gathering.hpp"

namespace bagnold::events {

/// Events of disks that touch and part.
template <bool Rotates>
class TouchEvents {
 public:
  using Group = TouchingGroup<Rotates>;
  using Touch = typename Group::Touch;
  using Moving = DiskMotion<Rotates>;

  explicit TouchEvents(EventState<Rotates>& state) : s_(state), gathering_(state) {}

  /// Disk i touches a neighbour.
  void touch(std::uint32_t i, Neighbor n, Real time);

  /// The step of a cluster ends.
  void end_step(std::uint32_t k);

  /// New paths for all of a group, by what hangs together in it, and what happens to them next.
  void settle(Group& group, Real time);

  /// The contact of two disks from a time on; the step of a cluster from its begin on.
  std::uint32_t add_contact(Moving const& a, Moving const& b, Touch const& touch, bool fresh,
                            Real time);
  void plan(std::uint32_t k);

  /// Closed form of a contact of two from a time on, at which both disks are known.
  void solve(LoneContact<Rotates>& contact, Moving const& a, Moving const& b, bool fresh,
             Real time);

  /// Tells the log when a contact will end.
  void expect_end(LoneContact<Rotates>& contact);

 private:
  std::uint32_t name(std::uint32_t i) const { return s_.disks.name[i]; }
  void begin_lone(std::uint32_t i, Neighbor n, Real time);
  std::uint32_t add_cluster(typename Group::Part const& part, Real time);

  EventState<Rotates>& s_;
  Gathering<Rotates> gathering_;
  std::vector<std::uint32_t> clusters_;
};

extern template class TouchEvents<false>;
extern template class TouchEvents<true>;

}  // namespace bagnold::events
