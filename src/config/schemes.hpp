// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace bagnold {

/// Names of the schemes, as in input and output.
inline constexpr std::string_view papers_scheme = "modified-velocity-verlet";  ///< P2 Eqs. 21-24
inline constexpr std::string_view two_stage_scheme = "two-stage-leapfrog";     ///< docs/accuracy.md

}  // namespace bagnold
