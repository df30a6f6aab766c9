// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "src/config/plan.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Estimate with bounds that were found to hold (docs/run_time.md).
RunTime run_time(double expected);

/// CPU time of the pictures at the end of a run, [s].
double pictures_take(Scene const& scene);

/// Estimates run times by stepping a similar system for a short time, with all measurements of the
/// run; nothing is written.
///
/// The system has at most 1024 disks, and costs are scaled to the scene's number. It is brought
/// near the steady state by the default scheme: sheared at 1e-3, then at a tenth of that, and so on
/// down to the run's rate, with velocities and spins scaled. If the scene's first state is given
/// and has at most 16384 disks, it is used instead.
///
/// Times are CPU times of this thread, so that other load of the machine matters little. Kokkos
/// must run. A system that fails throws NumericalError.
class RunTimeTrial {
 public:
  /// Takes about `budget` of CPU time, [s]. start: of a scene that is given one.
  RunTimeTrial(Scene const& scene, std::optional<State> start, double budget);

  /// Time of all replicas of a run on one core, from about `budget` of CPU time, [s]. Runs of one
  /// scene are to be given in the order in which they follow each other.
  RunTime time_of(Scene const& run, Plan const& plan, double budget);

  std::int64_t disks() const { return small_.disks.count; }  ///< of the system that is stepped

 private:
  /// Time of a run of the system, [s].
  struct Cost {
    double steps = 0;  ///< all of them
    double frame = 0;  ///< each measured frame
  };

  void shear(double rate, double strain, double budget);
  double start_takes(Scene const& run, double size, double slower) const;
  Cost cost(Scene const& run, Plan const& plan, double budget);

  Scene small_;  ///< the system: nothing measured, default scheme, rate of the state
  State state_;
  double start_seconds_ = 0;     ///< to relax random disks
  double start_iterations_ = 0;  ///< of that
};

}  // namespace bagnold
