// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/scheduler.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <exception>
#include <thread>

#include "src/run/last_words.hpp"

namespace bagnold::sweep {

namespace {

constexpr int round_ms = 100;    ///< between checks of signals and of folders in use
constexpr int most_waits = 100;  ///< rounds: a killed process may take a while to end a write
constexpr int asked_waits = 20;  ///< rounds: Slurm signals one process after the other

std::uintmax_t size_of(std::filesystem::path const& log) {
  std::error_code missing;
  auto const size = std::filesystem::file_size(log, missing);
  return missing ? 0 : size;
}

}  // namespace

Scheduler::Scheduler(Sweep const& sweep, SweepFolder const& folder, Work work,
                     SweepMonitor& monitor)
    : sweep_(sweep), folder_(folder), work_(std::move(work)), monitor_(monitor) {}

std::vector<Failure> Scheduler::run(std::vector<std::size_t> const& chains) {
  monitor_.begin(sweep_);
  for (auto const index : chains) chains_.push_back({sweep_.chains[index]});
  for (auto& chain : chains_)
    while (!chain.over() && folder_.finished(chain.points[chain.next]))
      monitor_.was_finished(chain.points[chain.next++]);
  std::exception_ptr failure;
  while (!running_.empty() || (!stopping_ && pending())) {
    if (!stopping_ && monitor_.stop_requested()) stop();
    try {
      if (!stopping_) start_points();
    } catch (...) {  // the system makes no more processes: those that run write checkpoints
      failure = std::current_exception();
      stop();
    }
    wait();
    look_at_points();
    monitor_.waited();
  }
  monitor_.end();
  if (failure) std::rethrow_exception(failure);
  std::vector<Failure> list;
  for (auto const& [point, failure] : failures_) list.push_back(failure);
  return list;
}

void Scheduler::stop() {
  stopping_ = true;
  for (auto const& [point, running] : running_) running.child.ask_to_stop();
}

bool Scheduler::pending() const {
  return std::ranges::any_of(chains_, [](Chain const& chain) { return !chain.over(); });
}

void Scheduler::start_points() {
  for (auto& chain : chains_) {
    if (running_.size() == work_.jobs) return;
    if (chain.busy || chain.over()) continue;
    auto const point = chain.points[chain.next];
    if (let_go(point)) start(chain, point);
  }
}

/// True if the point's folder is free, or has been in use for so long that the point itself shall
/// report it.
bool Scheduler::let_go(std::size_t point) {
  return !folder_.in_use(point) || ++waits_[point] > most_waits;
}

void Scheduler::start(Chain& chain, std::size_t point) {
  auto command = work_.command;
  command.push_back(folder_.point(point).string());
  command.insert(command.end(), work_.options.begin(), work_.options.end());
  auto const log = folder_.log(point);
  auto const before = size_of(log);
  running_.emplace(point, Running{Child(command, log), &chain, before});
  chain.busy = true;
  monitor_.started(point);
}

/// Waits for a report of a point, a signal, or the end of the round.
void Scheduler::wait() const {
  std::vector<pollfd> reports;
  for (auto const& [point, running] : running_)
    reports.push_back({running.child.reports(), POLLIN, 0});
  ::poll(reports.data(), reports.size(), round_ms);
}

void Scheduler::look_at_points() {
  for (auto at = running_.begin(); at != running_.end();) {
    auto& [point, running] = *at;
    if (auto const share = running.child.share()) monitor_.reached(point, *share);
    if (auto const code = running.child.exit_code()) {
      ended(running, point, *code);
      at = running_.erase(at);
    } else {
      ++at;
    }
  }
}

/// True if the signal went to this process and its points: a batch system or a terminal does that,
/// and a point may receive it first.
bool Scheduler::all_are_asked_to_stop(int signal) const {
  if (signal != SIGINT && signal != SIGTERM && signal != SIGHUP) return false;
  for (int k = 0; k < asked_waits && !monitor_.stop_requested(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(round_ms));
  return monitor_.stop_requested();
}

void Scheduler::ended(Running const& running, std::size_t point, int exit_code) {
  Chain& chain = *running.chain;
  chain.busy = false;
  if (exit_code == 0 && folder_.finished(point)) {
    ++chain.next;
    monitor_.finished(point);
    return;
  }
  if (exit_code > 128 && (stopping_ || all_are_asked_to_stop(exit_code - 128)))
    return monitor_.stopped(point);
  chain.next = chain.points.size();
  auto const words = exit_code > 128 ? fmt::format("ended by signal {}", exit_code - 128)
                                     : last_words(folder_.log(point), running.log_before);
  failures_[point] = {point, exit_code, words.empty() ? "ended without a word" : words};
  monitor_.failed(point);
}

}  // namespace bagnold::sweep
