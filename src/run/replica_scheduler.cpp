// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/replica_scheduler.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <numeric>
#include <system_error>
#include <thread>
#include <vector>

#include "src/config/errors.hpp"
#include "src/run/cores.hpp"
#include "src/run/messages.hpp"

namespace bagnold {

namespace {

using Clock = std::chrono::steady_clock;

std::deque<std::size_t> all_of(ReplicaScheduler const& work) {
  std::deque<std::size_t> systems(work.systems);
  std::iota(systems.begin(), systems.end(), std::size_t{0});
  return systems;
}

bool run_on_this_thread(ReplicaScheduler const& work) {
  auto waiting = all_of(work);
  bool stopped = false;
  while (!waiting.empty() && !stopped) {
    std::size_t const system = waiting.front();
    waiting.pop_front();
    auto const begun = Clock::now();
    bool const done = work.advance(system, [&] {
      auto const request = work.request();
      if (request == ReplicaScheduler::Request::hold) work.held();
      stopped = request == ReplicaScheduler::Request::stop;
      return !stopped && (waiting.empty() || Clock::now() - begun < work.turn);
    });
    if (!done) waiting.push_back(system);
  }
  return waiting.empty();
}

/// Threads that take the system that has waited longest. All members but the atomics are guarded by
/// mutex_.
class ThreadPool {
 public:
  explicit ThreadPool(ReplicaScheduler const& work) : work_(work), waiting_(all_of(work)) {
    waiting_count_ = waiting_.size();
  }

  ~ThreadPool() { end(); }

  bool run() {
    start_threads();
    std::unique_lock lock(mutex_);
    while (!over()) {
      changed_.wait_for(lock, std::chrono::milliseconds(50));
      lock.unlock();
      auto const request = work_.request();
      lock.lock();
      if (request != ReplicaScheduler::Request::go_on) hold(lock, request);
    }
    lock.unlock();
    end();
    if (failure_) std::rethrow_exception(failure_);
    return done_ == work_.systems;
  }

 private:
  /// Starts the threads. Throws FileError if the system does not make as many.
  void start_threads() try {
    for (int t = 0; t < work_.threads; ++t) threads_.emplace_back([this] { take_turns(); });
  } catch (std::system_error const& error) {
    end();
    throw FileError(no_more_threads(work_.threads));
  }

  bool over() const { return stopped_ || done_ == work_.systems; }

  void hold(std::unique_lock<std::mutex>& lock, ReplicaScheduler::Request request) {
    held_ = true;
    changed_.wait(lock, [&] { return busy_ == 0; });
    if (failure_) return;
    if (request == ReplicaScheduler::Request::stop)
      stopped_ = true;
    else
      work_.held();
    held_ = false;
    changed_.notify_all();
  }

  void end() {
    {
      std::lock_guard const lock(mutex_);
      stopped_ = held_ = true;
    }
    changed_.notify_all();
    for (auto& thread : threads_) thread.join();
    threads_.clear();
  }

  void take_turns() {
    use_all_cores_in_new_thread();
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [&] { return over() || (!held_ && !waiting_.empty()); });
      if (over()) return;
      std::size_t const system = waiting_.front();
      waiting_.pop_front();
      waiting_count_ = waiting_.size();
      ++busy_;
      lock.unlock();
      std::exception_ptr failure;
      bool const done = take_turn(system, failure);
      lock.lock();
      --busy_;
      if (failure) {
        if (!failure_) failure_ = failure;
        stopped_ = held_ = true;
      } else if (done) {
        ++done_;
      } else {
        waiting_.push_back(system);
        waiting_count_ = waiting_.size();
      }
      changed_.notify_all();
    }
  }

  bool take_turn(std::size_t system, std::exception_ptr& failure) {
    auto const begun = Clock::now();
    try {
      return work_.advance(system, [&] {
        return !held_ && (waiting_count_ == 0 || Clock::now() - begun < work_.turn);
      });
    } catch (...) {
      failure = std::current_exception();
      return false;
    }
  }

  ReplicaScheduler const& work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::size_t> waiting_;
  std::size_t done_ = 0;
  int busy_ = 0;
  bool stopped_ = false;
  std::exception_ptr failure_;      ///< the first
  std::atomic<bool> held_ = false;  ///< no thread begins or continues a turn
  std::atomic<std::size_t> waiting_count_ = 0;
  std::vector<std::thread> threads_;  ///< last: they use all of the above
};

}  // namespace

bool run(ReplicaScheduler const& work) {
  return work.threads > 1 ? ThreadPool(work).run() : run_on_this_thread(work);
}

}  // namespace bagnold
