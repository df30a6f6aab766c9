// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_engine.hpp"

#include <algorithm>
#include <utility>

#include "src/engine/device_copy.hpp"
#include "src/engine/engine_memory.hpp"
#include "src/engine/events/saved_events.hpp"
#include "src/engine/failure.hpp"
#include "src/engine/wrap_state.hpp"

namespace bagnold {

namespace {

template <bool Rotates>
std::vector<DiskMotion<Rotates>> moving_disks(State const& state) {
  auto const motion = motions<Rotates>(state);
  std::vector<DiskMotion<Rotates>> disks(state.count());
  for (std::size_t i = 0; i < disks.size(); ++i)
    disks[i] = {{state.position[i][0], state.position[i][1]}, motion[i]};
  return disks;
}

}  // namespace

template <bool Rotates>
EventEngine<Rotates>::EventEngine(events::Material<Rotates> const& material,
                                  StrainRates const& rates, double time_step, double skin,
                                  Snapshot const& snapshot)
    : clock_(rates, time_step, snapshot),
      diameter_(snapshot.state.diameter),
      system_(material, species_of(snapshot.state.diameter), skin, time_step),
      step_(snapshot.step),
      list_step_(snapshot.step),
      builds_(snapshot.list_builds),
      touches_known_(!snapshot.arrays.empty()) {
  visit_counters(*this, RestoreCounter{snapshot.counters});
  if (touches_known_) {
    restore(snapshot);
    return;
  }
  auto disks = moving_disks<Rotates>(snapshot.state);
  auto const box = clock_.box(clock_.mark(step_));
  for (auto& disk : disks) wrap(box, disk.position, disk.motion.velocity.x);
  system_.place(disks, box);
  ++builds_;
}

template <bool Rotates>
void EventEngine<Rotates>::restore(Snapshot const& snapshot) {
  list_step_ = snapshot.list_step;
  system_.restore(snapshot.arrays, vectors(snapshot.list_position),
                  clock_.box(clock_.mark(list_step_)));
  visit_memory(*this, RestoreMemory{snapshot.memory});
  system_.predict_all();
}

template <bool Rotates>
double* EventEngine<Rotates>::columns_of(std::int64_t window, OpenWindows& windows) const {
  auto& sums = windows.of(window).sums;
  auto const size = static_cast<std::size_t>(columns());
  if (sums.size() < size) sums.resize(size);
  return sums.data();
}

template <bool Rotates>
void EventEngine<Rotates>::advance(std::int64_t steps, Sampling const& sampling,
                                   OpenWindows& windows) {
  auto end = std::min(step_ + steps, sampling.last_step);
  bool const cuts_a_window = sampling.last_step % sampling.window_steps != 0;
  if (sampling.whole && cuts_a_window) end = std::min(end, sampling.last_step - 1);
  if (windows.contacts && !watches_contacts_) {
    watches_contacts_ = true;
    system_.watch_contacts(now());
  }
  while (step_ < end) {
    auto const window = sampling.window(step_);
    auto const window_end = std::min((window + 1) * sampling.window_steps, sampling.last_step);
    auto const from = step_;
    open_window(columns_of(window, windows));
    go_to(std::min(end, window_end));
    windows.of(window).weight += static_cast<double>(step_ - from);
    if (step_ == window_end) {
      system_.windows().end(now());
      in_window_ = false;
    }
    if (windows.contacts) tell_contacts(from, sampling, windows);
    if (step_ - list_step_ == system_.all().build_step) renew();
  }
}

template <bool Rotates>
void EventEngine<Rotates>::tell_contacts(std::int64_t from, Sampling const& sampling,
                                         OpenWindows& windows) {
  system_.tell_contacts(step_, list_step_, sampling, windows);
  windows.contacts->evaluated(from, step_, sampling, windows);
  if (in_window_) return;
  windows.contacts->add(system_.contact_motion(), step_ - 1, sampling, windows);
  system_.contact_motion() = {};
}

template <bool Rotates>
void EventEngine<Rotates>::open_window(double* columns) {
  if (in_window_) return system_.windows().resume(columns, system_.all().time(begun_ - list_step_));
  system_.windows().begin(columns, now());
  begun_ = step_;
  in_window_ = true;
  if (!std::exchange(touches_known_, true)) system_.find_touches();
}

/// To a step, or to where the lists are to be built.
template <bool Rotates>
void EventEngine<Rotates>::go_to(std::int64_t step) {
  step_ = list_step_ + system_.run(step - list_step_);
  if (auto const& deep = system_.all().too_deep)
    failure::too_deep(clock_, step_, deep->disk, deep->relative_overlap);
}

template <bool Rotates>
void EventEngine<Rotates>::renew() {
  system_.renew(now(), clock_.box(clock_.mark(step_)));
  list_step_ = step_;
  ++builds_;
}

template <bool Rotates>
void EventEngine<Rotates>::add_motions(State& state) const {
  auto const& disks = system_.all().disks;
  state.position.resize(disks.count());
  state.velocity.resize(disks.count());
  if constexpr (Rotates) state.spin.resize(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    auto const of = disks.at(i, now());
    state.position[i] = {of.position.x, of.position.y};
    state.velocity[i] = {of.motion.velocity.x, of.motion.velocity.y};
    if constexpr (Rotates) state.spin[i] = of.motion.spin;
  }
}

template <bool Rotates>
Snapshot EventEngine<Rotates>::snapshot() const {
  Snapshot s;
  add_motions(s.state);
  s.state.diameter = diameter_;
  clock_.tell(s.state, step_);
  s.list_position = pairs(system_.all().lists.at_build());
  s.list_step = list_step_;
  s.step = step_;
  s.initial_offset = clock_.initial_offset;
  s.initial_time = clock_.initial_time;
  s.list_builds = builds_;
  if (touches_known_) {
    s.arrays = events::save(system_.all().disks);
    visit_memory(*this, WriteDown{s.memory});
  }
  visit_counters(*this, WriteDown{s.counters});
  return s;
}

template <bool Rotates>
State EventEngine<Rotates>::state() const {
  State state = snapshot().state;
  return wrap_state(std::move(state));
}

template class EventEngine<false>;
template class EventEngine<true>;

}  // namespace bagnold
