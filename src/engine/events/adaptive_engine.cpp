// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/adaptive_engine.hpp"

#include <algorithm>
#include <utility>

#include "kernels/physics/sums/sums.hpp"
#include "src/engine/engine_memory.hpp"

namespace bagnold {

namespace {

using events::EventChoice;

constexpr char by_events_key[] = "adaptive_by_events";

/// Contacts and weight in windows from one on.
std::pair<double, double> contacts_from(std::int64_t window, OpenWindows const& windows) {
  double contacts = 0, weight = 0;
  for (auto w = static_cast<std::size_t>(window - windows.first); w < windows.sums.size(); ++w) {
    auto const& of = windows.sums[w];
    if (of.sums.empty()) continue;
    contacts += of.sums[SumColumns::contacts];
    weight += of.weight;
  }
  return {contacts, weight};
}

/// First step of a window.
std::int64_t begin_of(std::int64_t window, Sampling const& sampling) {
  return sampling.first_step + (window - sampling.first_window) * sampling.window_steps;
}

/// Number of configurations that steps would evaluate from one step to another of a window.
double evaluated(std::int64_t from, std::int64_t to, Sampling const& sampling) {
  auto const begin = begin_of(sampling.window(from), sampling);
  auto const before = [&](std::int64_t step) {
    return (step - begin + sampling.every - 1) / sampling.every;
  };
  return static_cast<double>(before(to) - before(from));
}

}  // namespace

AdaptiveEngine::AdaptiveEngine(Engines engines, Snapshot&& snapshot)
    : engines_(std::move(engines)),
      disks_(static_cast<double>(snapshot.state.count())),
      counters_(snapshot.counters),
      choice_(static_cast<std::int64_t>(snapshot.state.count())) {
  if (wrote(snapshot)) {
    for_each_memory(RestoreMemory{snapshot.memory});
    RestoreCounter{snapshot.counters}("steps_by_events", event_steps_);
    std::erase_if(snapshot.memory, [](auto const& m) { return m.first.starts_with("adaptive_"); });
  }
  engine_ = make(std::move(snapshot));
}

bool AdaptiveEngine::wrote(Snapshot const& snapshot) {
  return snapshot.memory.contains(by_events_key);
}

bool AdaptiveEngine::wrote_by_events(Snapshot const& snapshot) {
  return wrote(snapshot) && snapshot.memory.at(by_events_key) != 0;
}

void AdaptiveEngine::advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
  auto const end = std::min(step() + steps, sampling.last_step);
  while (step() < end) {
    auto const from = step();
    if (by_events_)
      go_by_events(end, sampling, windows);
    else
      go_by_steps(end, sampling, windows);
    if (step() == from) return;
    if (step() >= next_choice(from)) choose();
  }
}

/// To the next choice at most, or to the end of a window.
void AdaptiveEngine::go_by_events(std::int64_t end, Sampling const& sampling,
                                  OpenWindows& windows) {
  auto const from = step(), window = sampling.window(from);
  auto const part_end =
      std::min({begin_of(window + 1, sampling), next_choice(from), sampling.last_step});
  if (part_weight_ == 0) part_from_ = from;
  Sampling part = sampling;
  part.last_step = part_end;
  part.whole = sampling.whole && part_end == sampling.last_step;
  OpenWindows open;
  open.first = window;
  engine_->advance(std::min(end, part_end) - from, part, open);
  event_steps_ += step() - from;
  part_weight_ += open.of(window).weight;
  if (step() == part_end) add_part(open.take_first().sums, sampling, windows);
}

/// Events give their sums at the end of a part.
void AdaptiveEngine::add_part(std::vector<double>&& sums, Sampling const& sampling,
                              OpenWindows& windows) {
  contacts_ += sums[SumColumns::contacts];
  weight_ += part_weight_;
  double const configurations = evaluated(part_from_, step(), sampling);
  for (double& sum : sums) sum *= configurations / part_weight_;
  windows.add(sampling.window(part_from_), sums, configurations);
  part_weight_ = 0;
}

/// To the next choice, or to where the engine can stop behind it.
void AdaptiveEngine::go_by_steps(std::int64_t end, Sampling const& sampling, OpenWindows& windows) {
  auto const from = step(), window = sampling.window(from);
  auto const before = contacts_from(window, windows);
  engine_->advance(std::min(end, next_choice(from)) - from, sampling, windows);
  auto const after = contacts_from(window, windows);
  contacts_ += after.first - before.first;
  weight_ += after.second - before.second;
}

/// By what was counted since the last choice. If nothing was evaluated, more is awaited.
void AdaptiveEngine::choose() {
  if (weight_ == 0) return;
  double const number = contacts_ / (weight_ * disks_);
  contacts_ = weight_ = 0;
  if (!by_events_) {
    if (choice_.enters(number)) change();
    return;
  }
  double const work = EventChoice::work(engine_->counters());
  double const time = engines_.time_step * static_cast<double>(step() - chosen_step_);
  if (choice_.leaves(work - work_before_, disks_ * time)) {
    choice_.left(number);
    return change();
  }
  work_before_ = work;
  chosen_step_ = step();
}

void AdaptiveEngine::change() {
  by_events_ = !by_events_;
  Snapshot now = engine_->snapshot();
  now.counters = counters_ = joined(std::move(now.counters), counters_);
  engine_ = make(handed_over(std::move(now)));
  chosen_step_ = step();
  work_before_ = by_events_ ? EventChoice::work(engine_->counters()) : 0;
}

Snapshot AdaptiveEngine::snapshot() const {
  auto& self = const_cast<AdaptiveEngine&>(*this);  // visits do not change what they write down
  Snapshot snapshot = engine_->snapshot();
  snapshot.counters = joined(std::move(snapshot.counters), counters_);
  self.for_each_memory(WriteDown{snapshot.memory});
  WriteDown{snapshot.counters}("steps_by_events", event_steps_);
  return snapshot;
}

template <class Visit>
void AdaptiveEngine::for_each_memory(Visit const& visit) {
  visit(by_events_key, by_events_);
  visit("adaptive_contacts", contacts_);
  visit("adaptive_weight", weight_);
  visit("adaptive_chosen_step", chosen_step_);
  visit("adaptive_work_before", work_before_);
  visit("adaptive_part_from", part_from_);
  visit("adaptive_part_weight", part_weight_);
  choice_.for_each_memory(visit);
}

}  // namespace bagnold
