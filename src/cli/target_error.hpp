// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/cli/run_results.hpp"

namespace bagnold {

/// The number of windows at which errors are looked at next, from `windows` on: 100, and from there
/// a tenth more each time, `most` at last. What a run does depends on no clock, and errors that
/// scatter get few chances to look small.
std::int64_t next_look(std::int64_t windows, std::int64_t most);

/// Relative standard errors over the windows so far of what the scene has a target for.
std::map<std::string, std::optional<double>> reached_errors(Run const& run);

/// Whether run.reached is there and at or below its target for every name.
bool all_reached(Run const& run);

/// Where the scene leaves it open ("auto"): the windows to discard, by steady_start() of B_p and
/// B_sigma, averaged over replicas; the later one counts.
void discard_transient(Run& run);

/// Throws InputError where a target is for no NAME of the scene.
void check_target(Scene const& scene);

}  // namespace bagnold
