// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "src/engine/events/contact_log.hpp"
#include "src/engine/events/event_sums.hpp"
#include "src/engine/events/predictions.hpp"

namespace bagnold::events {

/// What has happened, for reports.
struct EventCounts {
  std::int64_t collisions = 0;       ///< contacts that began
  std::int64_t busy_collisions = 0;  ///< of these, with a disk that touched another one
  std::int64_t cluster_steps = 0;
};

/// A disk that overlaps too much, and how much.
struct DeepOverlap {
  std::uint32_t disk;
  Real relative_overlap;
};

/// All that moves on from event to event, in times since the lists were built.
template <bool Rotates>
struct EventState {
  EventState(Material<Rotates> const& material, std::vector<Species> const& species, Real skin,
             Real step)
      : time_step(step),
        disks(material, species),
        lists(skin),
        queue(disks.count()),
        predictions(disks, lists, queue),
        sums(disks, step),
        steps(disks.material, disks.shifts) {}
  EventState(EventState const&) = delete;

  Real const time_step;  ///< [tau_e]
  EventDisks<Rotates> disks;
  EventLists lists;
  EventQueue queue;
  Predictions<Rotates> predictions;
  EventSums<Rotates> sums;
  ClusterSteps<Rotates> steps;
  EventCounts counts;
  ContactLog log;
  std::int64_t build_step = 0;  ///< after which the lists are built anew at the latest
  Real now = 0;                 ///< of the last event, [tau_e]
  std::optional<DeepOverlap> too_deep;

  Real time(std::int64_t step) const { return time_step * static_cast<Real>(step); }

  /// The first step that ends at a time, or after it.
  std::int64_t step_at(Real from) const {
    auto const step = static_cast<std::int64_t>(std::ceil(from / time_step));
    if (time(step) < from) return step + 1;
    return time(step - 1) >= from ? step - 1 : step;
  }

  /// The lists are to be built at the first end of a step from a time on.
  void ask_for_build(Real from) {
    predictions.watch_reach = false;
    build_step = std::min(build_step, step_at(from));
  }

  void check_overlap(std::uint32_t disk, Real relative_overlap) {
    if (!(relative_overlap <= largest_relative_overlap) && !too_deep)
      too_deep = {disk, relative_overlap};
  }
};

}  // namespace bagnold::events
