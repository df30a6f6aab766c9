// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "src/config/errors.hpp"
#include "src/config/plan.hpp"
#include "src/engine/simulation.hpp"
#include "src/measure/frames.hpp"
#include "src/run/bias/pairs.hpp"
#include "src/run/protocols/controller.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold {

/// Measurements of a run so far.
struct Measurement {
  statistics::Windows windows;  ///< finished, from the first step on
  OpenWindows open;             ///< those in progress; of a controlled run pieces
  Frames frames;                ///< what observers see now and then
  std::unique_ptr<Controller> controller = nullptr;  ///< of a controlled run; else null
};

/// One of the systems that a run steps, and its measurements.
struct MeasuredSystem {
  Simulation& simulation;
  Measurement& measurement;
  bias::ReplicaPairs* pairs = nullptr;  ///< null: the bias is not measured
};

/// A NumericalError of one of several systems.
struct SystemFailure : NumericalError {
  SystemFailure(std::size_t which, NumericalError const& error)
      : NumericalError(error), system(which) {}
  std::size_t system;
};

/// End of a leg of a run: at the plan's last step, or before a lookahead that the last step would
/// cut short, from where a longer run continues with the same bits.
enum class LegEnd { exact, whole };

/// Shears a system until the plan's steps are done, from its present step.
///
/// `go_on` is called about twenty times a second, between steps; the frequency changes no bit.
/// Returns false if go_on did.
bool run_measured(Simulation& simulation, Plan const& plan, Measurement& measurement,
                  std::function<bool()> const& go_on, LegEnd end = LegEnd::exact);

/// Shears several systems, which advance in turn to the same step. Throws SystemFailure.
bool run_measured(std::span<MeasuredSystem const> systems, Plan const& plan,
                  std::function<bool()> const& go_on, LegEnd end = LegEnd::exact);

}  // namespace bagnold
