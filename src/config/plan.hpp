// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/config/ramp.hpp"

namespace bagnold {

struct Scene;

class PieceTable;

/// Windows of equal length one after the other; the last one may be shorter.
struct WindowRow {
  std::int64_t begin = 0;  ///< first step
  std::int64_t first = 0;  ///< number of the first window
  std::int64_t steps = 0;  ///< of a window
};

/// Steps and windows of a scene.
struct Plan {
  double time_step = 0;                ///< dt, [tau_e]
  std::int64_t steps = 0;              ///< total
  std::int64_t window_steps = 0;       ///< of a window, where they are alike; the last is shorter
  std::int64_t windows = 0;            ///< total
  std::int64_t discarded_windows = 0;  ///< first ones, not measured
  std::int64_t dropped_windows = 0;    ///< first ones, of a refused method; counted among these
  std::int64_t every = 1;              ///< steps between evaluations inside a window
  std::int64_t frame_steps = 1;        ///< between frames that are measured
  std::int64_t trajectory_steps = 0;   ///< between frames of the trajectory; 0: none
  double strain_rate = 0;              ///< gammadot, where there is one, [1/tau_e]
  std::optional<Ramp> ramp{};          ///< how it changes, where it does
  /// Pieces in which motions keep their excess over the flow; null: there are none.
  std::shared_ptr<PieceTable const> pieces{};
  std::vector<WindowRow> rows{};  ///< windows, where they are not alike
  /// Steps of a piece after which a controller decides on the rate or the box; 0: there is none.
  std::int64_t control_steps = 0;
  bool by_time = false;     ///< strain_rate is that of the start alone
  std::int64_t stages = 1;  ///< equal parts of the run, each at another stress

  bool has_one_rate() const { return !ramp && !pieces; }

  /// First step that is measured, where windows are alike.
  std::int64_t first_step() const { return discarded_windows * window_steps; }

  /// First step of a window, and the step after its last one.
  std::int64_t window_begin(std::int64_t window) const;
  std::int64_t window_end(std::int64_t window) const;

  /// Row of windows of a step, and the step after it.
  WindowRow row_of(std::int64_t step) const;
  std::int64_t row_end(WindowRow const& row) const;

  double strain(std::int64_t step) const;  ///< from step 0 to the start of `step`
  double path(std::int64_t step) const;    ///< the same, both signs added up
  /// Progress at a step, in words and as a number: the path; at given stress, where it is not known
  /// before, the time, [tau_e].
  char const* progress_name() const { return by_time ? "time" : "strain"; }
  double progress(std::int64_t step) const;
  double mean_rate(std::int64_t window) const;  ///< gammadot over a window, [1/tau_e]
  int direction(std::int64_t window) const;     ///< of a ramp: +1 up, -1 down; 0: none
};

/// R: radius about a disk within which measure.fields averages, P2 Fig. 27, [d_s].
inline constexpr double field_radius = 4.0;

/// Least width of a box in which no disk has two images within field_radius, [d_s].
double least_box_for_fields();

/// Makes the plan of a scene: strain, window and discarded share, rounded up to whole steps and
/// windows. Throws InputError where that is more than can be run or kept.
Plan make_plan(Scene const& scene);

/// Plan that ends after `windows` windows.
Plan shortened(Scene const& scene, Plan plan, std::int64_t windows);

/// Memory for frames of a trajectory that wait to be written, all replicas together, [bytes].
inline constexpr double trajectory_memory = 64 << 20;

/// Memory that a run needs in all, [bytes].
double memory_needed(Scene const& scene, Plan const& plan);

/// Checks that need the plan: stability of the time step (unless allowed), width of the box, memory
/// of this machine. Throws InputError.
void check_feasible(Scene const& scene, Plan const& plan, bool allow_unstable);

/// Warning before a run that is allowed to start; "" if there is none.
std::string plan_warning(Scene const& scene, Plan const& plan);

}  // namespace bagnold
