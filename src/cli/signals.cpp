// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/signals.hpp"

#include <unistd.h>

#include <csignal>
#include <initializer_list>

#include "src/sweep/report.hpp"

namespace bagnold {

namespace {

volatile std::sig_atomic_t checkpoint_flag = 0;
volatile std::sig_atomic_t stop_flag = 0;
volatile std::sig_atomic_t once_only = 0;

extern "C" void on_checkpoint_signal(int) { checkpoint_flag = 1; }

/// A terminal that closes may send SIGHUP twice, or SIGTERM behind it: neither is a user's
/// impatience.
extern "C" void on_stop_signal(int signal) {
  if (stop_flag == 0 || (stop_flag == SIGHUP && signal != SIGHUP))
    stop_flag = signal;
  else if (signal != SIGHUP && once_only == 0)
    _exit(128 + signal);
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
  // A terminal or batch system signals a sweep and its points, and the sweep passes its own on: a
  // point must not take the second for impatience. If the sweep quits at once, its points die with
  // it.
  once_only = sweep::report_pipe() >= 0;
  for (int const signal : {SIGINT, SIGTERM}) handle(signal, on_stop_signal);
  if (!ignored(SIGHUP)) handle(SIGHUP, on_stop_signal);
  // A closed pipe or a file size limit is no reason to lose a run: the write fails and says so.
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
