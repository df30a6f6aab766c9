// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/auto_scheme/auto_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "src/config/errors.hpp"
#include "src/config/names.hpp"
#include "src/config/schemes.hpp"
#include "src/engine/engine_memory.hpp"

namespace bagnold {

namespace {

constexpr char method_key[] = "auto_method", length_key[] = "auto_length",
               parts_key[] = "auto_parts", earlier_key[] = "auto_is_implicit";

/// Most steps of a run, times those of a method in one of them.
constexpr std::int64_t most = std::int64_t{1} << 62;

/// True if the checkpoint is of another method at its place of the list, where it says so.
bool is_another(std::map<std::string, double> const& memory, Method const& method) {
  auto const differs = [&](char const* key, std::int64_t value) {
    auto const saved = memory.find(key);
    return saved != memory.end() && saved->second != static_cast<double>(value);
  };
  return differs(length_key, method.length) || differs(parts_key, method.parts);
}

}  // namespace

AutoScheme::AutoScheme(Ladder ladder, Snapshot&& snapshot, Make make)
    : ladder_(std::move(ladder)), make_(std::move(make)), method_(ladder_.usual) {
  if (snapshot.memory.contains(earlier_key))
    throw InputError(
        "the checkpoint is of scheme = \"auto\" of version 1.0.0, which chose in another way; "
        "resume "
        "with the version that wrote it, or begin from its state with start.kind = \"state\"");
  if (snapshot.memory.contains(method_key)) {
    for_each_memory(RestoreMemory{snapshot.memory});
    for_each_counter(RestoreCounter{snapshot.counters});
    counters_ = snapshot.counters;
  }
  if (method_ >= ladder_.methods.size() || is_another(snapshot.memory, present()))
    throw InputError(fmt::format(
        "the checkpoint is of method {} of scheme = \"auto\", which is not among the {} here; "
        "resume with the version that wrote it",
        method_, ladder_.methods.size()));
  for (auto const* key : {method_key, length_key, parts_key}) snapshot.memory.erase(key);
  snapshot.step = own_steps(snapshot.step);
  engine_ = make_(present(), std::move(snapshot));
}

void AutoScheme::advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
  auto const end = std::min(step() + steps, sampling.last_step);
  while (step() < end) {
    auto const from = step(), place = (from / ladder_.grid + 1) * ladder_.grid;
    Sampling part = sampling;
    part.last_step = std::min(place, sampling.last_step);
    part.whole = sampling.whole && place > sampling.last_step;
    step_to(std::min(end, part.last_step), part, windows);
    auto const done = step() - from;
    if (is_implicit(present().scheme)) implicit_steps_ += done;
    if (present().scheme == backward_euler) quasi_static_steps_ += done;
    if (present().parts > 1) finer_steps_ += done;
    if (done == 0) return;
  }
}

/// Steps at least to `stop`, a whole step of the run, unless the engine stops before.
void AutoScheme::step_to(std::int64_t stop, Sampling const& sampling, OpenWindows& windows) {
  auto const parts = present().parts;
  bool const quasi_static = present().scheme == backward_euler;  // it evaluates every step
  Sampling const own{.window_steps = own_steps(sampling.window_steps),
                     .every = quasi_static ? 1 : std::min(sampling.every, most / parts) * parts,
                     .last_step = own_steps(sampling.last_step),
                     .whole = sampling.whole};
  auto const target = std::max(own_steps(stop), engine_->step() + 1);
  engine_->advance(target - engine_->step(), own, windows);
  while (engine_->step() % parts != 0)
    engine_->advance(parts - engine_->step() % parts, own, windows);
}

void AutoScheme::take_method(std::size_t method) {
  if (method == method_) return;
  Snapshot now = handed_over(engine_->snapshot());
  now.counters = counters_ = joined(std::move(now.counters), counters_);
  auto const step = run_steps(now.step);
  method_ = method;
  now.step = own_steps(step);
  engine_ = make_(present(), std::move(now));
}

std::int64_t AutoScheme::own_steps(std::int64_t of_run) const {
  return std::min(of_run, most / present().parts) * present().parts / present().length;
}

Snapshot AutoScheme::snapshot() const {
  auto& self = const_cast<AutoScheme&>(*this);  // saving changes nothing
  Snapshot snapshot = engine_->snapshot();
  snapshot.counters = joined(std::move(snapshot.counters), counters_);
  snapshot.step = run_steps(snapshot.step);  // that of the list is of the method's own
  self.for_each_memory(WriteDown{snapshot.memory});
  snapshot.memory[length_key] = static_cast<double>(present().length);
  snapshot.memory[parts_key] = static_cast<double>(present().parts);
  self.for_each_counter(WriteDown{snapshot.counters});
  return snapshot;
}

/// Visits the numbers that a bit-for-bit restart needs besides those of the engine.
template <class Visit>
void AutoScheme::for_each_memory(Visit const& visit) {
  visit(method_key, method_);
}

template <class Visit>
void AutoScheme::for_each_counter(Visit const& visit) {
  visit("steps_by_implicit_damping", implicit_steps_);
  visit("steps_by_quasi_static", quasi_static_steps_);
  visit("steps_in_parts", finer_steps_);
}

}  // namespace bagnold
