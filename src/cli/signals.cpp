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

extern "C" void on_signal(int signal) {
  if (signal == SIGUSR1) {
    checkpoint_flag = 1;
    return;
  }
  if (stop_flag != 0) {
    if (once_only == 0) _exit(128 + signal);
    return;
  }
  stop_flag = signal;
}

}  // namespace

void catch_signals() {
  // A terminal or batch system signals a sweep and its points, and the sweep passes its own on: a point
  // must not take the second for impatience. If the sweep quits at once, its points die with it.
  once_only = sweep::report_pipe() >= 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (int signal : {SIGUSR1, SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
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
