// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/run/results.hpp"

namespace bagnold {

/// Compares the windows so far with the scene's target errors: sets discarded windows, run.reached
/// and run.target_met (src/statistics/stopping.hpp). Depends on the windows of the run only, so
/// that a resumed run ends where an undisturbed one does.
void judge_errors(Run& run);

/// Command that makes a run that missed its targets long enough for them. Errors fall with the root
/// of the strain, so it takes (reached/wanted)^2 times the strain, or more if disks have collided
/// too rarely or independent windows are too few, and 1.5 times that so that the previous check
/// meets them too. "" if a target has no error.
std::string until_target(Run const& run);

/// Sets the windows to discard if the scene says "auto": steady_start() of
/// settling_names,
/// averaged over replicas; the later one counts. With a target error it is twice that, at most the
/// first half. MSER-5 cuts an exponential transient where it is as large as the noise; at twice
/// that nothing is left of it. The rest would bias a run that ends early by up to 0.8 of its error.
void discard_transient(Run& run);

/// Names of the observables by which a run is found steady.
std::vector<std::string_view> settling_names(Run const& run);

/// Throws InputError if a target is for a NAME that the scene does not have.
void check_target(Scene const& scene);

}  // namespace bagnold
