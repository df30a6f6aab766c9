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

/// Motion in a time that goes at another speed.
template <bool Rotates>
Motion<Rotates> scaled(Motion<Rotates> motion, double factor) {
  motion.velocity = factor * motion.velocity;
  if constexpr (Rotates) motion.spin *= factor;
  return motion;
}

/// Disks in a time that goes `speed` times as fast.
template <bool Rotates>
std::vector<DiskMotion<Rotates>> moving_disks(State const& state, double speed) {
  auto const motion = motions<Rotates>(state);
  std::vector<DiskMotion<Rotates>> disks(state.count());
  for (std::size_t i = 0; i < disks.size(); ++i)
    disks[i] = {{state.position[i][0], state.position[i][1]}, scaled(motion[i], 1 / speed)};
  return disks;
}

}  // namespace

template <bool Rotates>
EventEngine<Rotates>::EventEngine(events::Material<Rotates> const& material,
                                  StrainRates const& rates, double time_step, double skin,
                                  Snapshot const& snapshot, events::BlockPlan const& plan)
    : clock_(rates, time_step, snapshot),
      diameter_(snapshot.state.diameter),
      system_(material, species_of(snapshot.state.diameter), skin,
              events::StepTimes(rates, time_step), plan),
      step_(snapshot.step),
      list_step_(snapshot.step),
      builds_(snapshot.list_builds),
      touches_known_(!snapshot.arrays.empty()) {
  visit_counters(*this, RestoreCounter{snapshot.counters});
  if (touches_known_) {
    restore(snapshot);
    return;
  }
  if (clock_.strain_rate != system_.all().times.unit_rate()) given_ = snapshot.state;
  auto const box = box_at(step_);
  auto disks = moving_disks<Rotates>(snapshot.state, clock_.strain_rate / box.strain_rate);
  for (auto& disk : disks) wrap(box, disk.position, disk.motion.velocity.x);
  system_.place(disks, box, step_);
  ++builds_;
}

/// The box at a step, sheared as in the time of events.
template <bool Rotates>
ShearedBox EventEngine<Rotates>::box_at(std::int64_t step) const {
  auto const clock = clock_.at(step);
  auto box = clock.box(clock.mark(step));
  box.strain_rate = system_.all().times.unit_rate();
  return box;
}

template <bool Rotates>
void EventEngine<Rotates>::restore(Snapshot const& snapshot) {
  list_step_ = snapshot.list_step;
  system_.restore(snapshot.arrays, vectors(snapshot.list_position), box_at(list_step_), list_step_,
                  step_);
  visit_memory(*this, RestoreMemory{snapshot.memory});
  if (in_window_) {
    system_.windows().recall_rates(begun_, step_);
    open_window();
  }
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
    columns_of(window, windows);
    open_window();
    auto to = std::min(end, window_end);
    if (windows.contacts && windows.contacts->choice) {
      look_at_contacts(sampling, *windows.contacts);
      to = std::min(to, next_look(sampling, *windows.contacts));
    }
    go_to(to);
    windows.of(window).weight += static_cast<double>(step_ - from);
    if (step_ == window_end) {
      system_.windows().end(now(), columns_of(window, windows));
      in_window_ = false;
    }
    if (windows.contacts) tell_contacts(from, sampling, windows);
    if (step_ == clock_.rate_end) {
      change_rate();
    }
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

/// The first step after this one at which contacts may have to be sampled: a contact that begins is
/// in the first configuration that has it.
template <bool Rotates>
std::int64_t EventEngine<Rotates>::next_look(Sampling const& sampling,
                                             ContactRecord const& record) const {
  auto const happens = system_.next_event();
  auto const& times = system_.all().times;
  bool const soon = happens < times.time(system_.all().build_step);
  auto const event_step = soon ? list_step_ + times.step_at(happens) : StrainRates::never;
  auto due = SampleChoice::never;
  record.table.each([&](OpenContact const& contact) {
    if (contact.due > step_) due = std::min(due, contact.due);
  });
  return std::max(step_ + 1, std::min({sampling.next(step_ + 1), due, event_step}));
}

/// Samples the contacts of the configuration at this step.
template <bool Rotates>
void EventEngine<Rotates>::look_at_contacts(Sampling const& sampling, ContactRecord& record) const {
  auto const due = record.due(step_);
  bool const sampled = sampling.sampled(step_);
  if (due.empty() && !sampled) return;
  auto const picker = record.picker();
  std::vector<ContactPick> picks;
  auto const& all = system_.all();
  for (auto const& pair : events::touching_pairs(all, now())) {
    auto const velocities = [&] {
      return contact_velocities(pair.motion.separation, pair.motion.velocity, pair.spin,
                                all.times.unit_rate());
    };
    if (sampled) picker(picks, step_, pair.i, pair.j, velocities);
    for (auto const& contact : due)
      if (contact.a == pair.i && contact.b == pair.j)
        record.add(ContactSample{step_, pair.i, pair.j, velocities()});
  }
  record.add(picks);
}

template <bool Rotates>
void EventEngine<Rotates>::open_window() {
  if (!in_window_) begun_ = step_;
  auto const begun = system_.all().times.between(list_step_, begun_);  // as after a restart
  if (std::exchange(in_window_, true)) return system_.windows().resume(begun);
  system_.windows().begin(begun);
  if (!std::exchange(touches_known_, true)) system_.find_touches();
  given_.reset();
}

/// To a step, or to where the rate changes or the lists are to be built.
template <bool Rotates>
void EventEngine<Rotates>::go_to(std::int64_t step) {
  step_ = std::max(step_, list_step_ + system_.run(std::min(step, clock_.rate_end) - list_step_));
  if (auto const& deep = system_.all().too_deep)
    failure::too_deep(clock_, step_, system_.all().disks.name[deep->disk], deep->relative_overlap);
}

template <bool Rotates>
void EventEngine<Rotates>::renew() {
  constexpr std::int64_t often = 8;  // builds of the lists, between which disks stay near
  system_.renew(step_, box_at(step_), builds_ % often == 0);
  list_step_ = step_;
  ++builds_;
}

template <bool Rotates>
void EventEngine<Rotates>::change_rate() {
  clock_.move_to(step_);
  system_.change_rate(step_);
  if (in_window_) system_.windows().add_rate(begun_, step_);
}

template <bool Rotates>
void EventEngine<Rotates>::add_motions(State& state) const {
  auto const& disks = system_.all().disks;
  state.position.resize(disks.count());
  state.velocity.resize(disks.count());
  if constexpr (Rotates) state.spin.resize(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    auto const of = disks.at(i, now());
    auto const motion = scaled(of.motion, system_.all().times.speed());
    auto const name = disks.name[i];
    state.position[name] = {of.position.x, of.position.y};
    state.velocity[name] = {motion.velocity.x, motion.velocity.y};
    if constexpr (Rotates) state.spin[name] = motion.spin;
  }
}

template <bool Rotates>
Snapshot EventEngine<Rotates>::snapshot() const {
  // without known touches it begins anew
  Snapshot s = clock_.snapshot(step_, list_step_, touches_known_ ? builds_ : builds_ - 1);
  if (given_)
    s.state = *given_;
  else
    add_motions(s.state);
  s.state.diameter = diameter_;
  clock_.tell(s.state, step_);
  auto const& all = system_.all();
  s.list_position.resize(all.disks.count());
  for (std::uint32_t i = 0; i < all.disks.count(); ++i) {
    auto const& position = all.lists.at_build(i);
    s.list_position[all.disks.name[i]] = {position.x, position.y};
  }
  if (touches_known_) {
    s.arrays = events::save(all, now());
    visit_memory(*this, WriteDown{s.memory});
  }
  s.counters = counters();
  return s;
}

template <bool Rotates>
std::map<std::string, double> EventEngine<Rotates>::counters() const {
  std::map<std::string, double> counters;
  visit_counters(*this, WriteDown{counters});
  return counters;
}

template <bool Rotates>
State EventEngine<Rotates>::state() const {
  State state = snapshot().state;
  return wrap_state(std::move(state));
}

template class EventEngine<false>;
template class EventEngine<true>;

}  // namespace bagnold
