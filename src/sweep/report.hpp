// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold::sweep {

// How a point tells the sweep that started it where it stands: shares of its strain, in [0, 1], as
// doubles through a pipe whose descriptor is in the environment.
inline constexpr char const* report_variable = "BAGNOLD_SWEEP_PIPE";

/// The pipe of the sweep that started this process; -1: no sweep did.
int report_pipe();

/// Tells the sweep, if there is one. A full or closed pipe is no matter.
void report_share(double share);

}  // namespace bagnold::sweep
