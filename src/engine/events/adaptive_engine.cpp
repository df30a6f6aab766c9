// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/adaptive_engine.hpp"

#include <algorithm>
#include <utility>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/events.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/engine_memory.hpp"

namespace bagnold {

namespace {

/// A snapshot that another engine goes on from: the state alone.
Snapshot handed_over(Snapshot&& snapshot) {
  Snapshot to = std::move(snapshot);
  to.list_position.clear();
  to.list_step = 0;
  to.memory.clear();
  to.arrays.clear();
  return to;
}

double contacts_of(OpenWindows& windows, std::int64_t window) {
  auto const& sums = windows.of(window).sums;
  return sums.empty() ? 0 : sums[SumColumns::contacts];
}

}  // namespace

AdaptiveEngine::AdaptiveEngine(Scene const& scene, Snapshot&& snapshot, Make make)
    : of_events_(scene),
      of_steps_(scene),
      make_(std::move(make)),
      disks_(static_cast<double>(snapshot.state.count())),
      time_step_(time_step(scene)),
      counters_(snapshot.counters) {
  of_events_.integration.engine = event_engine;
  of_events_.integration.scheme = exact_contacts;
  of_events_.integration.skin = automatic;
  of_steps_.integration.engine = "auto";
  of_steps_.integration.scheme = scheme_of(scene);
  for (auto* of : {&of_events_, &of_steps_}) of->integration.time_step = time_step_;
  if (snapshot.memory.contains("adaptive_by_events")) {
    for_each_memory(RestoreMemory{snapshot.memory});
    RestoreCounter{snapshot.counters}("steps_by_events", event_steps_);
    std::erase_if(snapshot.memory, [](auto const& m) { return m.first.starts_with("adaptive_"); });
  }
  engine_ = make_(by_events_ ? of_events_ : of_steps_, std::move(snapshot));
}

void AdaptiveEngine::advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
  auto const end = std::min(step() + steps, sampling.last_step);
  while (step() < end) {
    auto const from = step();
    if (by_events_)
      go_by_events(sampling, windows);
    else
      go_by_steps(end, sampling, windows);
    if (step() == from) return;
  }
}

/// One window, or what the end of the run leaves of it.
void AdaptiveEngine::go_by_events(Sampling const& sampling, OpenWindows& windows) {
  auto const from = step(), window = sampling.window(from);
  auto const window_end = (window + 1) * sampling.window_steps;
  if (sampling.whole && window_end > sampling.last_step) return;  // a longer run would not cut it
  Sampling part = sampling;
  part.last_step = std::min(window_end, sampling.last_step);
  part.whole = false;
  auto const before = engine_->snapshot().counters;
  OpenWindows held;
  held.first = window;
  while (step() < part.last_step) engine_->advance(part.last_step - step(), part, held);
  event_steps_ += step() - from;
  auto& of = held.of(window);
  auto const evaluated = (sampling.window_steps - 1) / sampling.every + 1;
  double const share = static_cast<double>(evaluated) / static_cast<double>(sampling.window_steps);
  double const number = of.sums[SumColumns::contacts] / (of.weight * disks_);
  for (double& sum : of.sums) sum *= share;
  windows.add(window, of.sums, share * of.weight);
  double const time = time_step_ * static_cast<double>(step() - from);
  auto const after = engine_->snapshot().counters;
  auto const count = [&](char const* name) { return after.at(name) - before.at(name); };
  if (choice_.leaves(count("collisions"), count("cluster_steps"), count("carried_contacts"),
                     disks_ * time)) {
    choice_.left(number);
    change();
  }
}

/// Up to the end of a window.
void AdaptiveEngine::go_by_steps(std::int64_t end, Sampling const& sampling, OpenWindows& windows) {
  auto const window = sampling.window(step());
  auto const window_end = (window + 1) * sampling.window_steps;
  Sampling part = sampling;
  part.last_step = std::min(window_end, sampling.last_step);
  part.whole = sampling.whole && window_end > sampling.last_step;
  double const contacts = contacts_of(windows, window), weight = windows.of(window).weight;
  engine_->advance(std::min(end, part.last_step) - step(), part, windows);
  contacts_ += contacts_of(windows, window) - contacts;
  weight_ += windows.of(window).weight - weight;
  if (step() < window_end) return;
  double const number = contacts_ / (weight_ * disks_);
  contacts_ = weight_ = 0;
  if (choice_.enters(number)) change();
}

void AdaptiveEngine::change() {
  by_events_ = !by_events_;
  Snapshot now = engine_->snapshot();
  now.counters = counters_ = counters(now.counters);
  engine_ = make_(by_events_ ? of_events_ : of_steps_, handed_over(std::move(now)));
}

/// Those of the engine at work, and the others of engines before.
AdaptiveEngine::Counters AdaptiveEngine::counters(Counters const& of_engine) const {
  Counters all = of_engine;
  all.insert(counters_.begin(), counters_.end());
  return all;
}

Snapshot AdaptiveEngine::snapshot() const {
  auto& self = const_cast<AdaptiveEngine&>(*this);  // visits do not change what they write down
  Snapshot snapshot = engine_->snapshot();
  snapshot.counters = counters(snapshot.counters);
  self.for_each_memory(WriteDown{snapshot.memory});
  WriteDown{snapshot.counters}("steps_by_events", event_steps_);
  return snapshot;
}

template <class Visit>
void AdaptiveEngine::for_each_memory(Visit const& visit) {
  visit("adaptive_by_events", by_events_);
  visit("adaptive_contacts", contacts_);
  visit("adaptive_weight", weight_);
  choice_.for_each_memory(visit);
}

}  // namespace bagnold
