// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/cores.hpp"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "src/run/cpu_quota.hpp"

namespace bagnold {

namespace {

constexpr int mask_words =
    8192 / (8 * sizeof(unsigned long));  ///< Linux has 8192 processors at most

unsigned long start_mask[mask_words];  ///< a bit a processor
long start_mask_bytes = 0;             ///< 0: not known

/// Runs before the constructors of all libraries, OpenMP's among them, and before a sanitizer is
/// ready.
__attribute__((no_sanitize("address", "undefined", "thread"))) void note_start_mask(int, char**,
                                                                                    char**) {
  start_mask_bytes = ::syscall(SYS_sched_getaffinity, 0, sizeof start_mask, start_mask);
}

__attribute__((section(".preinit_array"), used)) void (*const note_early)(int, char**,
                                                                          char**) = note_start_mask;

int cores_in_mask() {
  int count = 0;
  for (auto const word : start_mask) count += std::popcount(word);
  return count;
}

}  // namespace

int cores() {
  int const allowed = start_mask_bytes > 0 ? cores_in_mask()
                                           : static_cast<int>(std::thread::hardware_concurrency());
  double const paid = std::floor(std::min(cpu_quota(), 1e6));
  return std::max(1, std::min(allowed, static_cast<int>(paid)));
}

void use_all_cores() {
  if (start_mask_bytes > 0)
    ::syscall(SYS_sched_setaffinity, 0, static_cast<std::size_t>(start_mask_bytes), start_mask);
}

void use_all_cores_in_new_thread() {
#ifdef _OPENMP
  [[maybe_unused]] int volatile region = 0;
#pragma omp parallel num_threads(1)
  region = 1;  // an empty region might be left out by the compiler
#endif
  use_all_cores();
}

void unbind_new_program() {
  use_all_cores();
  for (auto const* name : {"OMP_PROC_BIND", "OMP_PLACES", "GOMP_CPU_AFFINITY", "KMP_AFFINITY"})
    ::unsetenv(name);
}

}  // namespace bagnold
