// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/pairs.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace bagnold::bias {

std::int64_t ReplicaPairs::next(std::int64_t step) const {
  std::lock_guard const lock(shared_.mutex);
  return std::max(step + 1, shared_.course.next(replica_));
}

bool ReplicaPairs::awaited(std::int64_t step) const {
  std::lock_guard const lock(shared_.mutex);
  return is_due(step);
}

std::vector<double> ReplicaPairs::save() const {
  std::lock_guard const lock(shared_.mutex);
  return shared_.course.save(replica_);
}

/// An engine that is far ahead may find two places of the grid behind it: they make one pair.
bool ReplicaPairs::is_due(std::int64_t step) const {
  auto const& course = shared_.course;
  auto const& before = course.pairs(replica_);
  return !shared_.ended && step >= course.next(replica_) &&
         (before.empty() || before.back().step < step);
}

bool ReplicaPairs::take(Simulation const& run, std::function<bool()> const& go_on) {
  auto const step = run.step();
  Methods const* methods = nullptr;
  {
    std::unique_lock lock(shared_.mutex);
    if (!is_due(step)) return true;
    if (!shared_.course.takes(replica_)) {
      lock.unlock();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return false;
    }
    methods = &shared_.course.methods();
  }
  if (!start_) start_ = run.state();
  auto const averages_of = [&](Scene const& scene, std::int64_t every) -> std::optional<Averages> {
    if (!stretch_)
      stretch_ = std::make_unique<Stretch>(scene, *start_, shared_.backend, methods->third, every);
    if (!stretch_->advance(go_on)) return {};
    auto const found = stretch_->averages();
    stretch_.reset();
    return found;
  };
  if (!coarse_) coarse_ = averages_of(methods->coarse, 1);
  if (!coarse_) return false;
  auto const fine = averages_of(methods->fine, methods->ratio);
  if (!fine) return false;
  std::lock_guard const lock(shared_.mutex);
  shared_.course.add(replica_, {step, *coarse_, *fine});
  start_.reset();
  coarse_.reset();
  return true;
}

}  // namespace bagnold::bias
