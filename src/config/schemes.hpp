// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// Words for the choice of a scheme or of a time step.
inline constexpr char automatic[] = "auto";  ///< the best of those known
inline constexpr char default_scheme[] = "two-stage-leapfrog";
inline constexpr char backward_euler[] = "backward-euler";  ///< of quasi-static steps
inline constexpr char of_papers[] = "paper";  ///< of a time step: what the papers took

}  // namespace bagnold
