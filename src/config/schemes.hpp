// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace bagnold {

/// Names of the schemes, as in input and output.
inline constexpr std::string_view papers_scheme = "modified-velocity-verlet";  ///< P2 Eqs. 21-24
inline constexpr std::string_view two_stage_scheme = "two-stage-leapfrog";     ///< docs/accuracy.md

/// Words for the choice of a scheme or of a time step.
inline constexpr char automatic[] = "auto";   ///< the best of those known
inline constexpr char of_papers[] = "paper";  ///< of a time step: what the papers took

}  // namespace bagnold
