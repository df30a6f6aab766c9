// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

namespace bagnold {

/// Several systems that are advanced at the same time, each by one thread at a time.
struct ReplicaScheduler {
  /// What the calling thread wants of all: to go on, to be held while `held` is called, to end.
  enum class Request { go_on, hold, stop };

  std::size_t systems = 0;
  int threads = 1;

  /// Works on one system until it is done (returns true) or `go_on`, which it is to ask about
  /// twenty times a second, says no. By any thread, but never by two at once for the same system.
  std::function<bool(std::size_t system, std::function<bool()> const& go_on)> advance;

  /// Asked by the calling thread about twenty times a second; may show how far all have got.
  std::function<Request()> request = [] { return Request::go_on; };

  /// Called by the calling thread while no system is worked on.
  std::function<void()> held = [] {};

  /// After this a system gives way to one that waits for a thread: all get on alike, and no thread
  /// is idle until the very end, however many systems there are for a thread.
  std::chrono::milliseconds turn{500};
};

/// Furthers all systems until they are done; false where `request` stopped them before. With one
/// thread all is done by the caller's, which OpenMP and CUDA want. What `advance` throws ends all,
/// and is thrown here once no system is worked on; what `request` and `held` throw likewise.
bool run(ReplicaScheduler const& work);

}  // namespace bagnold
