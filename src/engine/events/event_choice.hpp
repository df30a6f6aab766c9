// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

namespace bagnold::events {

/// Choice of the cheaper of events and steps of all disks, by counts alone, so that no run depends
/// on a clock or on threads. Measured for CD_n (docs/data/performance/tried.md).
class EventChoice {
 public:
  explicit EventChoice(std::int64_t disks)
      : most_collisions_(disks < many_disks ? most_collisions : most_of_many) {}

  /// Steps from one choice to the next, of a run at one rate: a strain of 0.01, but long enough to
  /// count contacts in. Of a run whose rate changes at any time that alone.
  static std::int64_t stretch(double step_strain, bool at_one_rate) {
    constexpr std::int64_t shortest = 4096;
    auto const times = static_cast<std::int64_t>(0.01 / (step_strain * shortest));
    return at_one_rate ? shortest * std::max<std::int64_t>(1, times) : shortest;
  }

  /// True if events are tried after a stretch of steps with this contact number.
  bool enters(double contact_number) const { return contact_number < enter_below_; }

  /// Work that events have done, in collisions. counters: of the engine of events.
  static double work(std::map<std::string, double> const& counters) {
    return counters.at("collisions") + counters.at("carried_contacts") +
           cost_of_cluster_step * counters.at("cluster_steps");
  }

  /// True if events are given up. work: since they were asked before; disk_time: N times
  /// the time since, [tau_e].
  bool leaves(double work, double disk_time) const { return work > most_collisions_ * disk_time; }

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

  /// From here on a collision waits for memory and takes 1.7 to 2.6 times as long, a step hardly
  /// longer, on any number of threads.
  static constexpr std::int64_t many_disks = 8192;
  static constexpr double most_of_many = 0.0085;

  double most_collisions_;    ///< a disk and tau_e
  double enter_below_ = 0.1;  ///< contact number
};

}  // namespace bagnold::events
