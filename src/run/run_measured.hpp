// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "src/config/errors.hpp"
#include "src/config/plan.hpp"
#include "src/engine/simulation.hpp"
#include "src/measure/frames.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold {

/// What a run has measured so far.
struct Measurement {
  statistics::Windows windows;  ///< finished, from the first step on
  OpenWindows open;             ///< those in progress
  Frames frames;                ///< what observers see now and then
};

/// One of the systems that a run steps, and what it has measured of it.
struct MeasuredSystem {
  Simulation& simulation;
  Measurement& measurement;
};

/// A NumericalError of one of several systems.
struct SystemFailure : NumericalError {
  SystemFailure(std::size_t which, NumericalError const& error)
      : NumericalError(error), system(which) {}
  std::size_t system;
};

/// Where a leg of a run ends: at the plan's last step, or before a lookahead that this would cut
/// short, from where a longer run goes on with the same bits.
enum class LegEnd { exact, whole };

/// Shear at a constant rate until the plan's steps are done, from wherever the simulation is.
///
/// `go_on` is called about twenty times a second, between steps; how often changes no bit. Returns
/// false where it did.
bool run_measured(Simulation& simulation, Plan const& plan, Measurement& measurement,
                  std::function<bool()> const& go_on, LegEnd end = LegEnd::exact);

/// The same for several systems, told to advance in turn to the same step. Throws SystemFailure.
bool run_measured(std::span<MeasuredSystem const> systems, Plan const& plan,
                  std::function<bool()> const& go_on, LegEnd end = LegEnd::exact);

}  // namespace bagnold
