// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "src/engine/events/event_blocks.hpp"
#include "src/engine/events/event_windows.hpp"
#include "src/engine/events/saved_events.hpp"

namespace bagnold::events {

/// Disks from event to event.
///
/// A disk that touches nobody flies straight. Two that touch each other alone are one event: where
/// their contact begins, both get the line on which they go on after it. What hits a disk that is
/// in contact makes a cluster, from the state that the closed form has there; clusters are stepped
/// until they fall apart, and a pair that is left over goes back to the closed form at its phase.
/// Nothing is ever rolled back: a contact under way causes nothing before its end, and what was
/// predicted from its end is known to be stale by the number of changes of a path.
template <bool Rotates>
class EventSystem {
 public:
  using Moving = DiskMotion<Rotates>;

  EventSystem(Material<Rotates> const& material, std::vector<Species> const& species, Real skin,
              StepTimes const& times, BlockPlan const& plan)
      : s_(material, species, skin, times, plan.group), loop_(s_), windows_(s_) {
    if (plan.each) blocks_.emplace(s_, loop_, plan);
  }

  /// Disks that fly from a step on, in the box, whether they overlap or not.
  void place(std::vector<Moving> const& disks, ShearedBox const& box, std::int64_t step);

  /// Goes on from what was saved at a step, with the lists of positions then.
  void restore(Arrays const& from, std::vector<Vec2<Real>> const& list_position,
               ShearedBox const& box, std::int64_t list_step, std::int64_t step);

  /// Predicts everything anew.
  void predict_all() {
    if (by_blocks())
      blocks_->look_again();
    else
      loop_.predict_all();
  }

  /// Visits the other memory on which its bits depend.
  template <class Visit>
  void visit_memory(Visit const& visit) {
    visit_memory_of(s_, visit);
  }
  template <class Visit>
  void visit_memory(Visit const& visit) const {
    visit_memory_of(s_, visit);
  }

  /// Finds who touches at time 0, at the start of a run, in a window.
  void find_touches();

  /// Does what happens up to the end of a step, counted from the build of the lists, or to where
  /// they are to be built: returns that step.
  std::int64_t run(std::int64_t step);

  /// Builds the lists at a step, from which times are counted then. box: there, its offset in
  /// [0, L_x). sorted: whether disks that are near each other are given near places in memory.
  void renew(std::int64_t step, ShearedBox const& box, bool sorted);

  /// The rate changes at a step: contacts and clusters go on from there with other constants.
  void change_rate(std::int64_t step);

  /// Windows of measurement.
  EventWindows<Rotates>& windows() { return windows_; }

  EventState<Rotates> const& all() const { return s_; }

  /// When something happens next.
  Real next_event() const { return s_.queue.times.first_time(); }
  EventCounts& counts() { return s_.counts; }
  EventCounts const& counts() const { return s_.counts; }

  /// Contacts are reported from now on, at a time.
  void watch_contacts(Real time);

  /// Their motion in the window under way.
  ContactMotion& contact_motion() { return s_.log.motion; }
  ContactMotion const& contact_motion() const { return s_.log.motion; }

  /// Tells of all up to the end of a step.
  void tell_contacts(std::int64_t step, std::int64_t list_step, Sampling const& sampling,
                     OpenWindows& windows) {
    s_.log.tell(
        s_.times.time(step - list_step), [&](Real t) { return list_step + s_.times.step_at(t); },
        sampling, windows);
  }

 private:
  bool by_blocks() const { return blocks_ && !s_.log.on; }

  template <class All, class Visit>
  static void visit_memory_of(All& all, Visit const& visit) {
    visit("events_build_step", all.build_step);
  }

  std::vector<std::uint32_t> forget_ended_contacts(Real time);
  template <class OfContact, class OfCluster>
  void for_each_under_way(Real time, OfContact const& of_contact, OfCluster const& of_cluster);
  void sort(std::vector<Vec2<Real>>& position, ShearedBox const& box);
  void build(std::vector<Vec2<Real>> const& position, ShearedBox const& box);

  EventState<Rotates> s_;
  EventLoop<Rotates> loop_;
  EventWindows<Rotates> windows_;
  std::optional<EventBlocks<Rotates>> blocks_;
};

extern template class EventSystem<false>;
extern template class EventSystem<true>;

}  // namespace bagnold::events
