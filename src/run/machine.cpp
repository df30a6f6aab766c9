// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "kernels/device/initialize_kokkos.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene.hpp"
#include "src/engine/levels/levels.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/run/cores.hpp"
#include "src/run/messages.hpp"

namespace bagnold {

namespace {

bool has(std::string const& backend) {
  auto const all = backend_names();
  return std::find(all.begin(), all.end(), backend) != all.end();
}

constexpr int most_kokkos_threads = 512;  ///< the length of its pool, which it does not check
constexpr std::int64_t disks_of_a_thread = 4096;  ///< where a run is not told how many threads

int most_openmp_threads() {
#ifdef _OPENMP
  return std::min(most_kokkos_threads, omp_get_thread_limit());
#else
  return most_kokkos_threads;
#endif
}

/// Reduces `threads` to those that can be made. Returns false if all can.
bool leave_out_threads(int& threads) {
  int const most = most_openmp_threads();
  if (threads <= most) return false;
  warn(fmt::format("--threads {} (must be at most {}, which {}): {} used", threads, most,
                   most < most_kokkos_threads ? "OMP_THREAD_LIMIT allows" : "Kokkos bears",
                   most == 1 ? "1 is" : fmt::format("{} are", most)));
  threads = most;
  return true;
}

Machine choose_for_replicas(Machine machine, Scene const& scene) {
  auto const replicas = scene.disks.replicas;
  auto const wanted = std::int64_t{machine.threads == 0 ? cores() : machine.threads};
  if (is_device_backend(machine.backend)) {  // threads relax the starts
    bool const together = steps_together(scene, machine.backend);
    machine.threads = together ? static_cast<int>(std::min(wanted, replicas)) : 1;
    return machine;
  }
  if (!machine.backend.empty() && machine.backend != "serial")
    throw InputError(
        fmt::format("--backend {}: disks.replicas = {} (must be 1 there: replicas run side by "
                    "side, each on the "
                    "serial backend); leave --backend out",
                    machine.backend, replicas));
  if (!has("serial"))
    throw InputError(fmt::format(
        "disks.replicas = {} (must be 1: this build lacks the serial backend, on which replicas "
        "run); build Kokkos with Kokkos_ENABLE_SERIAL",
        replicas));
  machine.backend = "serial";
  machine.threads = static_cast<int>(std::min(wanted, replicas));
  return machine;
}

/// Removes settings from the environment that would give Kokkos another number of threads.
void free_from_environment([[maybe_unused]] int threads) {
  for (auto const* name : {"KOKKOS_NUM_THREADS", "KOKKOS_DISABLE_WARNINGS"}) unsetenv(name);
#ifdef _OPENMP
  omp_set_dynamic(0);
  omp_set_num_threads(threads);  // Kokkos starts as many as the environment says, to count them
  omp_set_max_active_levels(std::max(1, omp_get_max_active_levels()));
#endif
}

/// OpenMP ends the program with exit(1) if the system makes no more threads. While this object
/// lives that exit has a message and an exit code of this program.
class StartingThreads {
 public:
  explicit StartingThreads(int threads) {
    if (!registered_) std::atexit(end_in_words);
    registered_ = true;
    wanted_ = threads;
  }
  ~StartingThreads() { wanted_ = 0; }

 private:
  static void end_in_words() {
    if (wanted_ == 0) return;
    say(no_more_threads(wanted_));
    std::fflush(nullptr);
    std::_Exit(4);
  }

  static inline bool registered_ = false;
  static inline int wanted_ = 0;  ///< 0: no threads are being started
};

}  // namespace

KokkosScope::KokkosScope(Machine const& machine, Scene const& scene)
    : outermost_(!Kokkos::is_initialized()) {
  if (!outermost_) return;
  // Threads of OpenMP stay where the user's OMP_PROC_BIND has put them.
  if (machine.backend != "openmp" || machine.threads == 1) use_all_cores();
  int const threads = scene.disks.replicas > 1 ? 1 : machine.threads;
  free_from_environment(threads);
  StartingThreads const starting(threads);
  initialize_kokkos(threads);
}

KokkosScope::~KokkosScope() {
  if (outermost_) Kokkos::finalize();
}

Machine choose(Machine machine, Scene const& scene) {
  if (!machine.backend.empty() && !has(machine.backend))
    throw InputError(fmt::format("--backend {}: not in this build (has: {})", machine.backend,
                                 fmt::join(backend_names(), ", ")));
  chosen_level();  // says early what is wrong with BAGNOLD_SIMD
  if (auto const why = why_no_start(); !why.empty())
    throw InputError(fmt::format(
        "no CUDA device ({}): this build needs one, also for --backend serial; run it where "
        "nvidia-smi lists one, or build without CUDA (cmake --preset openmp)",
        why));
  if (scene.measure.bias && is_device_backend(machine.backend))
    throw InputError(fmt::format(
        "--backend {}: measure.bias = true (pairs of stretches are stepped on the host alone); use "
        "--backend serial",
        machine.backend));
  if (scene.disks.replicas > 1) return choose_for_replicas(machine, scene);
  if (machine.threads == 0)
    machine.threads = static_cast<int>(
        std::clamp<std::int64_t>(scene.disks.count / disks_of_a_thread, 1,
                                 std::min<std::int64_t>(cores(), most_openmp_threads())));
  if (machine.backend != "serial" && !leave_out_threads(machine.threads))
    warn_of_threads_beyond_cores(machine.threads);
  if (machine.backend.empty())
    machine.backend = machine.threads > 1 && has("openmp") ? "openmp" : backend_names().front();
  if (machine.backend == "serial") machine.threads = 1;
  return machine;
}

void warn_of_threads_beyond_cores(int threads) {
  if (threads <= cores()) return;
  warn(
      fmt::format("--threads {} (more than the {} that this process may use: in each step all "
                  "threads wait for those that share a core); use --threads {}",
                  threads, cores() == 1 ? "one core" : fmt::format("{} cores", cores()), cores()));
}

int default_threads(Scene const& scene) {
  return why_no_start().empty() ? choose({}, scene).threads : 1;
}

}  // namespace bagnold
