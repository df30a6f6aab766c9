// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/auto_scheme/auto_scheme.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "src/config/errors.hpp"
#include "src/engine/engine_memory.hpp"

namespace bagnold {

namespace {

/// Snapshot for another engine: without lists and memory, with steps of its own.
Snapshot handed_over(Snapshot&& snapshot, std::int64_t step) {
  Snapshot to = std::move(snapshot);
  to.step = step;
  to.list_position.clear();
  to.list_step = 0;
  to.memory.clear();
  return to;
}

/// Keeps only the engine's own memory.
void forget_choice(Snapshot& snapshot) {
  std::erase_if(snapshot.memory, [](auto const& one) { return one.first.starts_with("auto_"); });
}

/// Sums of a stretch, over all its windows.
WindowSums sum_of(OpenWindows const& windows) {
  OpenWindows all;
  for (auto const& window : windows.sums)
    if (window.weight > 0) all.add(0, window.sums, window.weight);
  return all.of(0);
}

}  // namespace

AutoScheme::AutoScheme(Engines engines, Snapshot&& snapshot)
    : engines_(std::move(engines)),
      stretch_(engines_.length * std::max(least_steps, least_samples * engines_.every)) {
  if (!snapshot.memory.empty()) {
    for_each_memory(RestoreMemory{snapshot.memory});
    for_each_counter(RestoreCounter{snapshot.counters});
    forget_choice(snapshot);
  }
  if (is_implicit_) snapshot.step /= engines_.length, snapshot.list_step /= engines_.length;
  engine_ = make(std::move(snapshot));
}

std::int64_t AutoScheme::step() const {
  return engine_->step() * (is_implicit_ ? engines_.length : 1);
}

void AutoScheme::advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
  auto const end = std::min(step() + steps, sampling.last_step);
  while (step() < end) {
    auto const begin = step() / stretch_ * stretch_;
    bool const whole = step() == begin && begin + stretch_ <= sampling.last_step;
    if (whole && choice_.implicit()) {
      try_stretch(sampling, windows);
      continue;
    }
    if (sampling.whole && choice_.implicit()) return;  // a longer run would try the stretch
    auto const from = step();
    step_by_two_stages(begin, end, sampling, windows);
    if (step() == from) return;
  }
}

/// Steps up to the next trial or, in a last piece shorter than a stretch, to its end.
void AutoScheme::step_by_two_stages(std::int64_t begin, std::int64_t end, Sampling const& sampling,
                                    OpenWindows& windows) {
  if (is_implicit_) change_to_two_stages();
  auto const next_trial = begin + std::max<std::int64_t>(1, choice_.pause_left()) * stretch_;
  Sampling part = sampling;
  part.last_step = std::min(next_trial, sampling.last_step);
  part.whole = sampling.whole && next_trial > sampling.last_step;
  engine_->advance(std::min(end, part.last_step) - step(), part, windows);
  for (auto done = begin + stretch_; done <= step(); done += stretch_)
    choice_.explicit_stretch_done();
}

void AutoScheme::try_stretch(Sampling const& sampling, OpenWindows& windows) {
  auto const begin = step();
  Snapshot kept = snapshot();
  if (!is_implicit_) change_to_implicit();
  OpenWindows held;
  held.first = begin / sampling.window_steps;
  if (!step_stretch(sampling, held)) {
    go_back(std::move(kept));
    return;
  }
  implicit_steps_ += stretch_;
  for (auto const& window : held.sums) {
    if (window.weight > 0) windows.add(held.first, window.sums, window.weight);
    ++held.first;
  }
}

/// Steps a stretch of implicit damping. Returns whether it may be kept. It is given up after a
/// quarter that shows that motions are not overdamped.
bool AutoScheme::step_stretch(Sampling const& sampling, OpenWindows& held) {
  auto const begin = engine_->step(), length = stretch_ / engines_.length;
  constexpr std::int64_t parts = 4;
  try {
    for (std::int64_t part = 1; part <= parts; ++part) {
      Sampling const scaled{.window_steps = sampling.window_steps / engines_.length,
                            .every = sampling.every,
                            .last_step = begin + length * part / parts};
      while (engine_->step() < scaled.last_step)
        engine_->advance(scaled.last_step - engine_->step(), scaled, held);
      if (!SchemeChoice::is_overdamped(sum_of(held))) return choice_.refuse();
    }
  } catch (NumericalError const&) {
    return choice_.refuse();
  }
  double const rate = engines_.strain_rate;
  double const strain = rate * engines_.time_step * static_cast<double>(stretch_);
  bool const keeps = choice_.keeps(sum_of(held), strain, rate);
  auto const weight = static_cast<double>(engines_.length);
  for (auto& window : held.sums) {
    for (double& sum : window.sums) sum *= weight;
    window.weight *= weight;
  }
  return keeps;
}

void AutoScheme::change_to_implicit() {
  auto const step = engine_->step() / engines_.length;
  is_implicit_ = true;
  engine_ = make(handed_over(engine_->snapshot(), step));
}

void AutoScheme::change_to_two_stages() {
  auto const step = engine_->step() * engines_.length;
  is_implicit_ = false;
  engine_ = make(handed_over(engine_->snapshot(), step));
}

/// Returns to the start of a stretch that is not kept, from where two stages continue.
void AutoScheme::go_back(Snapshot&& kept) {
  ++refused_;
  bool const was_implicit = kept.memory.at("auto_is_implicit") != 0;
  if (was_implicit) kept = handed_over(std::move(kept), kept.step);
  forget_choice(kept);
  is_implicit_ = false;
  engine_ = make(std::move(kept));
}

Snapshot AutoScheme::snapshot() const {
  auto& self = const_cast<AutoScheme&>(*this);  // saving changes nothing
  Snapshot snapshot = engine_->snapshot();
  if (is_implicit_) snapshot.step *= engines_.length, snapshot.list_step *= engines_.length;
  self.for_each_memory(WriteDown{snapshot.memory});
  self.for_each_counter(WriteDown{snapshot.counters});
  return snapshot;
}

/// Visits the numbers that a bit-for-bit restart needs besides those of the engine.
template <class Visit>
void AutoScheme::for_each_memory(Visit const& visit) {
  visit("auto_is_implicit", is_implicit_);
  choice_.for_each_memory(visit);
}

template <class Visit>
void AutoScheme::for_each_counter(Visit const& visit) {
  visit("steps_by_implicit_damping", implicit_steps_);
  visit("implicit_stretches_refused", refused_);
}

}  // namespace bagnold
