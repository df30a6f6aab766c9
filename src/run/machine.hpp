// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

struct Scene;

/// Backend and threads of a run; none of it changes its bits.
struct Machine {
  std::string backend;  ///< "" chooses
  int threads = 0;      ///< 0 chooses
};

/// Chooses threads and backend where the user left them open. One system: a thread for every 4096
/// disks, up to the number of cores (with fewer disks, threads mostly wait for each other); one
/// thread runs on Serial. Threads beyond the limits of Kokkos or OMP_THREAD_LIMIT are left out,
/// with a warning; more threads than cores give a warning.
///
/// Replicas: one a thread on Serial, as many threads as there are cores; on a device all at once,
/// where threads only relax their starts. Throws InputError for a backend that the build does not
/// have or that cannot run replicas, and if Kokkos cannot start.
Machine choose(Machine machine, Scene const& scene);

/// Warns if threads of one system are more than the cores that this process may use.
void warn_of_threads_beyond_cores(int threads);

/// Number of threads of choose() by default; 1 if Kokkos cannot start.
int default_threads(Scene const& scene);

/// Lifetime of Kokkos. Each replica has a thread of its own, outside Kokkos.
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
