// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/run/results.hpp"

namespace bagnold {

/// How the windows so far stand to the scene's target errors: sets discarded windows, run.reached
/// and run.target_met (src/statistics/stopping.hpp). Depends on the windows of the run only, so
/// that a resumed run ends where an undisturbed one does.
void judge_errors(Run& run);

/// The command that makes a run that missed its targets long enough for them: errors fall with the
/// root of the strain, so it takes (reached/wanted)^2 times the strain, or more where disks have
/// collided too seldom or independent windows are too few, and 1.5 times that for the look before
/// to meet them too. "" where one has no error.
std::string until_target(Run const& run);

/// Where the scene leaves it open ("auto"): the windows to discard, by steady_start() of B_p and
/// B_sigma, averaged over replicas; the later one counts. Where the scene has a target error it is
/// twice that, the first half at most: of an exponential transient that MSER-5 cuts where it is as
/// large as the noise, nothing is left there, while the rest of it would bias a run that ends early
/// by up to 0.8 of its error.
void discard_transient(Run& run);

/// Throws InputError where a target is for no NAME of the scene.
void check_target(Scene const& scene);

}  // namespace bagnold
