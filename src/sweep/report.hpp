// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold::sweep {

// Pipe through which a point reports progress to the sweep that started it: shares of its strain,
// in [0, 1], as doubles; its descriptor is in the environment.
inline constexpr char const* report_variable = "BAGNOLD_SWEEP_PIPE";

/// Pipe of the sweep that started this process; -1 if none did.
int report_pipe();

/// Reports to the sweep, if there is one. A full or closed pipe is ignored.
void report_share(double share);

}  // namespace bagnold::sweep
