// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/pairs.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/errors.hpp"

namespace bagnold::bias {

namespace {

void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// p_kin/p of the last windows, as many; infinite where none is known.
double kinetic_share(statistics::Windows const& windows, std::int64_t last) {
  using C = SumColumns;
  auto const count = std::min(windows.size(), static_cast<std::size_t>(last));
  if (count == 0) return HUGE_VAL;
  auto const sums = windows.mean(windows.size() - count, windows.size());
  double const kinetic = sums[C::kinetic_xx] + sums[C::kinetic_yy];
  double const all = kinetic + sums[C::elastic_xx] + sums[C::elastic_yy] + sums[C::dissipative_xx] +
                     sums[C::dissipative_yy];
  return all > 0 ? kinetic / all : HUGE_VAL;
}

}  // namespace

std::int64_t ReplicaPairs::next(std::int64_t step) const {
  std::lock_guard const lock(shared_.mutex);
  auto const& course = shared_.course;
  auto const grid = course.chooses() ? course.grid() : 1;
  return std::max((step / grid + 1) * grid, course.next(replica_));
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
         (!course.chooses() || step % course.grid() == 0) &&
         (before.empty() || before.back().step < step);
}

std::int64_t ReplicaPairs::every(std::int64_t usual) const {
  std::lock_guard const lock(shared_.mutex);
  auto const& course = shared_.course;
  if (!course.begun(replica_)) return usual;
  return course.own() == Own::coarse ? 1 : course.methods().ratio;
}

bool ReplicaPairs::take(Simulation& run, statistics::Windows const& windows,
                        std::function<bool()> const& go_on) {
  do {
    if (!take_due(run, windows, go_on)) return false;
    std::unique_lock lock(shared_.mutex);
    auto const& course = shared_.course;
    if (!course.chooses()) return true;
    if (!course.takes(replica_) && run.step() >= course.end()) {  // the method may change here
      lock.unlock();
      wait();
      return false;
    }
    auto const method = course.method();
    auto const dropped = course.dropped();
    lock.unlock();
    if (run.method() != method) run.take_method(method);
    if (std::exchange(dropped_, dropped) != dropped) left_(dropped);
  } while (awaited(run.step()));  // a pair ends where the next one begins
  return true;
}

/// Adds the pair one side of which are the run's windows since it began.
void ReplicaPairs::add_own(Simulation const& run, statistics::Windows const& windows) {
  auto& course = shared_.course;
  auto const& [step, other] = *course.begun(replica_);
  auto const& methods = course.methods();
  bool const coarse = course.own() == Own::coarse;
  auto const [first, last] = course.windows_from(step);
  auto const own = averages_of(coarse ? methods.coarse : methods.fine, run.state().box_length,
                               windows, first, last);
  course.add(replica_, coarse ? Pair{step, own, other} : Pair{step, other, own});
}

bool ReplicaPairs::take_due(Simulation const& run, statistics::Windows const& windows,
                            std::function<bool()> const& go_on) {
  auto const step = run.step();
  Methods const* methods = nullptr;
  Own own;
  Scene run_by;
  {
    std::unique_lock lock(shared_.mutex);
    if (!is_due(step)) return true;
    if (!shared_.course.takes(replica_)) {
      lock.unlock();
      wait();
      return false;
    }
    auto& course = shared_.course;
    if (course.begun(replica_)) {
      add_own(run, windows);
      return true;
    }
    double const kinetic = kinetic_share(windows, course.late_windows());
    if (auto const none = course.without_pair(step, kinetic, run.has_step())) {
      course.add(replica_, *none);
      return true;
    }
    methods = &course.methods();
    own = course.own();
    run_by = course.run_by();
  }
  if (!start_) start_ = run.state();
  auto const averages_of = [&](Scene const& scene, std::int64_t every) -> std::optional<Averages> {
    if (!stretch_)
      stretch_ =
          std::make_unique<Stretch>(scene, handed_over(*start_, run_by, scene, shared_.backend),
                                    shared_.backend, methods->third, every);
    if (!stretch_->advance(go_on)) return {};
    auto const found = stretch_->averages();
    stretch_.reset();
    return found;
  };
  std::optional<Averages> fine;
  bool failed = false;
  try {
    if (own != Own::coarse && !coarse_) {
      coarse_ = averages_of(methods->coarse, 1);
      if (!coarse_) return false;
    }
    if (own != Own::fine) {
      fine = averages_of(methods->fine, methods->ratio);
      if (!fine) return false;
    }
  } catch (NumericalError const&) {
    stretch_.reset();
    failed = true;
  }
  std::lock_guard const lock(shared_.mutex);
  auto& course = shared_.course;
  if (failed)
    course.add(replica_, Pair::failed(step));
  else if (own == Own::neither)
    course.add(replica_, {step, *coarse_, *fine});
  else
    course.begin(replica_, step, own == Own::coarse ? *fine : *coarse_);
  start_.reset();
  coarse_.reset();
  return true;
}

}  // namespace bagnold::bias
