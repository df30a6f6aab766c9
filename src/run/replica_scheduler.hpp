// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

namespace bagnold {

/// Several systems that are advanced at the same time, each by one thread at a time.
struct ReplicaScheduler {
  /// Request of the calling thread to all systems: continue, pause while `held` is called, or stop.
  enum class Request { go_on, hold, stop };

  std::size_t systems = 0;
  int threads = 1;

  /// Advances one system until it is done (returns true) or `go_on`, which it asks about twenty
  /// times a second, returns false. Called by any thread, but never by two at once for the same
  /// system.
  std::function<bool(std::size_t system, std::function<bool()> const& go_on)> advance;

  /// Asked by the calling thread about twenty times a second; may show the progress of all systems.
  std::function<Request()> request = [] { return Request::go_on; };

  /// Called by the calling thread while no system is being advanced.
  std::function<void()> held = [] {};

  /// Time after which a system gives way to one that waits for a thread. All systems advance at the
  /// same pace, and no thread is idle until the very end, however many systems there are for a
  /// thread.
  std::chrono::milliseconds turn{500};
};

/// Advances all systems until they are done. Returns false if `request` stopped them before. With
/// one thread all work is done by the calling thread, which OpenMP and CUDA need. An exception of
/// `advance`, `request` or `held` ends all systems, and is thrown here once no system is being
/// advanced.
bool run(ReplicaScheduler const& work);

}  // namespace bagnold
