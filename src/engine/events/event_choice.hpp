// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace bagnold::events {

/// Whether events or steps of all disks cost less, by counts of a window alone, so that no run
/// depends on a clock. Measured for CD_n, N = 1024 (docs/performance.md).
class EventChoice {
 public:
  /// Of steps of all disks, by the contact number of a window: whether events are tried.
  bool enters(double contact_number) const { return contact_number < enter_below_; }

  /// Of events: whether they are given up. carried: contacts over changes of the rate; disk_time: N
  /// times the time of the window, [tau_e].
  bool leaves(double collisions, double cluster_steps, double carried, double disk_time) const {
    return collisions + carried + cost_of_cluster_step * cluster_steps >
           most_collisions * disk_time;
  }

  /// They were, at a contact number: no new trial until there are clearly fewer contacts.
  void left(double contact_number) {
    enter_below_ = std::min(enter_below_, clearly_fewer * contact_number);
  }

  template <class Visit>
  void for_each_memory(Visit const& visit) {
    visit("adaptive_enter_below", enter_below_);
  }

 private:
  static constexpr double cost_of_cluster_step = 3.5;  ///< in collisions: 2.5 us against 0.7 us
  static constexpr double most_collisions = 0.017;     ///< a disk and tau_e: 12 ns, as steps cost
  static constexpr double clearly_fewer = 0.7;

  double enter_below_ = 0.1;  ///< contact number
};

}  // namespace bagnold::events
