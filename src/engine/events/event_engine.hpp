// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/engine/events/event_system.hpp"
#include "src/engine/run_clock.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// Contacts as events, on threads of the host: no time step where disks fly (docs/events.md).
///
/// Where the rate changes, velocities and spins are scaled with it. A step is a unit of time for
/// windows, frames and lists; it acts on nothing else. Sums are integrals over time in the place of
/// sums over configurations, one a step.
template <bool Rotates>
class EventEngine final : public Simulation {
 public:
  EventEngine(events::Material<Rotates> const& material, StrainRates const& rates, double time_step,
              double skin, Snapshot const& snapshot, events::BlockPlan const& plan = {});

  int columns() const override { return Sums<Rotates>::columns; }
  std::int64_t step() const override { return step_; }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  Snapshot snapshot() const override;
  std::map<std::string, double> counters() const override;
  State state() const override;

  /// Present time on the clock of events, since the build of the lists.
  double now() const { return system_.all().times.time(step_ - list_step_); }
  events::EventState<Rotates> const& all() const { return system_.all(); }

 private:
  template <class Self, class Visit>
  static void visit_counters(Self& self, Visit const& visit) {
    auto&& counts = self.system_.counts();
    visit("collisions", counts.collisions);
    visit("busy_collisions", counts.busy_collisions);
    visit("cluster_steps", counts.cluster_steps);
    visit("carried_contacts", counts.carried_contacts);
  }

  /// Visits the memory on which bits depend, beside paths and lists.
  template <class Self, class Visit>
  static void visit_memory(Self& self, Visit const& visit) {
    self.system_.visit_memory(visit);
    for (int c = 0; c < ContactMotion::count; ++c) {
      auto const name = "events_motion_" + std::to_string(c);
      visit(name.c_str(), self.system_.contact_motion().value[c]);
    }
    visit("events_in_window", self.in_window_);
    visit("events_window_begun", self.begun_);
  }

  ShearedBox box_at(std::int64_t step) const;
  double* columns_of(std::int64_t window, OpenWindows& windows) const;
  void open_window();
  void tell_contacts(std::int64_t from, Sampling const& sampling, OpenWindows& windows);
  std::int64_t next_look(Sampling const& sampling, ContactRecord const& record) const;
  void look_at_contacts(Sampling const& sampling, ContactRecord& record) const;
  void go_to(std::int64_t step);
  void renew();
  void change_rate();
  void restore(Snapshot const& snapshot);
  void add_motions(State& state) const;

  RunClock clock_;
  std::vector<double> diameter_;  ///< [N], as files have it
  events::EventSystem<Rotates> system_;
  std::int64_t step_;
  std::int64_t list_step_;  ///< of the last build of the lists
  std::int64_t builds_;
  bool touches_known_;  ///< of the start
  /// State of the start, where the clock of events is another one than time, until the first window
  /// begins: scaled to and fro, velocities would not be those that were given.
  std::optional<State> given_;
  bool in_window_ = false;
  bool watches_contacts_ = false;
  std::int64_t begun_ = 0;  ///< step from which on the window under way is summed
};

extern template class EventEngine<false>;
extern template class EventEngine<true>;

}  // namespace bagnold
