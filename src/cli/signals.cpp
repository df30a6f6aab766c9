// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/signals.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <initializer_list>

#include "src/sweep/report.hpp"

namespace bagnold {

namespace {

volatile std::sig_atomic_t checkpoint_flag = 0;
volatile std::sig_atomic_t once_only = 0;

// Several threads may handle signals at the same time.
std::atomic<int> stop_flag = 0;
std::atomic<std::int64_t> asked_at = 0;        ///< SIGINT or SIGTERM came first, [ms]; 0: not yet
std::atomic<std::int64_t> interrupted_at = 0;  ///< SIGINT came first, [ms]; 0: not yet
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "else no signal handler may use it");

constexpr std::int64_t patience_ms = 1000;  ///< closer signals count as one
constexpr std::int64_t one_press_ms =
    50;  ///< `timeout -s INT` sends SIGINT twice; a user is slower

extern "C" void on_checkpoint_signal(int) { checkpoint_flag = 1; }

std::int64_t clock_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // a signal handler may
  return 1 + std::int64_t{1000} * now.tv_sec + now.tv_nsec / 1000000;
}

/// Milliseconds since the first call; 0: this is the first.
std::int64_t since_first(std::atomic<std::int64_t>& first, std::int64_t now) {
  std::int64_t before = 0;
  return first.compare_exchange_strong(before, now) ? 0 : now - before;
}

/// Batch systems ask twice: Slurm's preemption sends SIGTERM to the step and to the job,
/// milliseconds apart; `timeout` to the process and to its group; a terminal that closes sends
/// SIGHUP twice, or SIGTERM behind it. A user presses Ctrl-C again, or asks again later.
extern "C" void on_stop_signal(int signal) {
  int none = 0, closed = SIGHUP;
  if (!stop_flag.compare_exchange_strong(none, signal) && signal != SIGHUP)
    stop_flag.compare_exchange_strong(closed, signal);
  if (signal == SIGHUP) return;
  auto const now = clock_ms();
  bool const pressed_again = signal == SIGINT && since_first(interrupted_at, now) >= one_press_ms;
  bool const impatient = since_first(asked_at, now) >= patience_ms || pressed_again;
  if (impatient && once_only == 0) _exit(128 + signal);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

bool ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void catch_checkpoint_signal() { handle(SIGUSR1, on_checkpoint_signal); }

void catch_signals() {
  // A terminal or batch system signals a sweep and its points, and the sweep passes its own signal
  // on: a point must not take the second signal for a second request. If the sweep quits at once,
  // its points end with it.
  once_only = sweep::report_pipe() >= 0;
  for (int const signal : {SIGINT, SIGTERM}) handle(signal, on_stop_signal);
  if (!ignored(SIGHUP)) handle(SIGHUP, on_stop_signal);
  // A closed pipe or a file size limit must not end a run: the write fails with a message.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool checkpoint_requested() {
  bool const requested = checkpoint_flag != 0;
  checkpoint_flag = 0;
  return requested;
}

int stop_signal() { return stop_flag; }

}  // namespace bagnold
