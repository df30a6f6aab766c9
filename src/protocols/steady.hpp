// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "src/config/plan.hpp"
#include "src/measure/frames.hpp"
#include "src/simulation/simulation.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold {

/// What a run has measured so far.
struct Measurement {
  statistics::Windows windows;  ///< finished, from the first step on
  OpenWindows open;             ///< those in progress
  Frames frames;                ///< what observers see now and then
};

/// Shear at a constant rate until the plan's steps are done, from wherever the simulation is.
///
/// `go_on` is called about twenty times a second, between steps; how often changes no bit. Returns
/// false where it did.
bool run_steady(Simulation& simulation, Plan const& plan, Measurement& measurement,
                std::function<bool()> const& go_on);

}  // namespace bagnold
