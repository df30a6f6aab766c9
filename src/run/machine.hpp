// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/scene.hpp"

namespace bagnold {

/// On what a run runs; none of it changes its bits.
struct Machine {
  std::string backend;  ///< "" chooses
  int threads = 0;      ///< 0 chooses
};

/// Threads and backend where the user left them open. One system: a thread for every 4096 disks, as
/// far as there are cores (fewer wait for each other more than they work); one thread runs on
/// Serial. Threads that Kokkos or OMP_THREAD_LIMIT do not allow are left out, with a warning; more
/// of them than cores are warned of.
/// Replicas: one a thread on Serial, as many threads as there are cores; on a device all at once,
/// where threads only relax their starts. Throws InputError for a backend that the build does not
/// have or that cannot run replicas, and where Kokkos cannot start.
Machine choose(Machine machine, Scene const& scene);

/// Says where threads of one system are more than the cores that this process may use.
void warn_of_threads_beyond_cores(int threads);

/// Threads that choose() takes where all is left to it; 1 where Kokkos cannot start.
int default_threads(Scene const& scene);

/// Kokkos, running. Replicas bring their own threads, each a system's only one.
class KokkosScope {
 public:
  KokkosScope(Machine const& machine, Scene const& scene);
  ~KokkosScope();
  KokkosScope(KokkosScope const&) = delete;
  KokkosScope& operator=(KokkosScope const&) = delete;

 private:
  bool outermost_;  ///< Kokkos can be started once in a process
};

}  // namespace bagnold
