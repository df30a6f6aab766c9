// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// Number of cores that this process may use, at least 1: those of its initial affinity mask
/// (taskset, Slurm, cpusets), or the whole cores within the CPU quota of its control groups, if
/// these are fewer.
int cores();

/// Gives the calling thread the affinity mask that the process was started with. OpenMP binds the
/// first thread of a program to one core before main() if OMP_PROC_BIND, OMP_PLACES or
/// GOMP_CPU_AFFINITY are set, and threads and processes that are made later inherit that.
void use_all_cores();

/// Gives a new thread of the program this affinity mask for as long as it lives. OpenMP binds such
/// a thread to a core in its first parallel region, so one is entered first here. Some versions of
/// Kokkos (4.7.00) fill Views in a parallel region, also for kernels on the serial backend.
void use_all_cores_in_new_thread();

/// In a new process before exec(): use_all_cores(), and no OpenMP environment that would bind each
/// of several programs to the same core.
void unbind_new_program();

}  // namespace bagnold
