// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "src/engine/events/contact_log.hpp"
#include "src/engine/events/event_sums.hpp"
#include "src/engine/events/predictions.hpp"
#include "src/engine/events/step_times.hpp"

namespace bagnold::events {

/// Counts of events, for reports.
struct EventCounts {
  std::int64_t collisions = 0;       ///< contacts that began
  std::int64_t busy_collisions = 0;  ///< of these, with a disk that touched another one
  std::int64_t cluster_steps = 0;
  std::int64_t carried_contacts = 0;  ///< of two disks alone, over a change of the rate

  EventCounts& operator+=(EventCounts const& more) {
    collisions += more.collisions;
    busy_collisions += more.busy_collisions;
    cluster_steps += more.cluster_steps;
    carried_contacts += more.carried_contacts;
    return *this;
  }
};

/// A disk that overlaps too much, and how much.
struct DeepOverlap {
  std::uint32_t disk;
  Real relative_overlap;
};

inline constexpr std::uint32_t usual_group = 1024;  ///< disks that are added up together

/// All that moves on from event to event, in times since the lists were built (StepTimes).
template <bool Rotates>
struct EventState {
  EventState(Material<Rotates> const& material, std::vector<Species> const& species, Real skin,
             StepTimes const& of_steps, std::uint32_t group = usual_group, OwnDisks const& own = {})
      : at_first_rate(material),
        times(of_steps),
        disks(material, species, own),
        lists(skin),
        queue(disks.count()),
        predictions(disks, lists, queue),
        sums(disks, times.time_step(), group),
        steps(disks.material, disks.shifts) {}
  EventState(EventState const&) = delete;

  Material<Rotates> const at_first_rate;
  StepTimes times;
  EventDisks<Rotates> disks;
  EventLists lists;
  EventQueue queue;
  Predictions<Rotates> predictions;
  EventSums<Rotates> sums;
  ClusterSteps<Rotates> steps;
  EventCounts counts;
  ContactLog log;
  std::int64_t build_step = 0;  ///< after which the lists are built anew at the latest
  std::optional<DeepOverlap> too_deep;

  /// Takes the rate from a step of the run on.
  void move_to(std::int64_t step) {
    times.move_to(step);
    disks.material =
        Material<Rotates>::of(at_first_rate.damping, at_first_rate.table, times.speed());
    sums.set_speed(times.speed());
  }

  /// A disk is out of its reach: the lists are to be built at the first end of a step from a time
  /// on, but not where they were built last: the line on which a disk leaves a contact under way
  /// may pass its place at the build by more than the reach.
  void ask_for_build(std::uint32_t disk, Real from) {
    if (disks.owns(disk))
      build_step = std::min(build_step, std::max<std::int64_t>(1, times.step_at(from)));
  }
  Real build_time() const { return times.time(build_step); }

  void check_overlap(std::uint32_t disk, Real relative_overlap) {
    if (disks.owns(disk) && !(relative_overlap <= largest_relative_overlap) && !too_deep)
      too_deep = {disk, relative_overlap};
  }
};

}  // namespace bagnold::events
