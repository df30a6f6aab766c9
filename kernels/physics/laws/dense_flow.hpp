// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/vec2.hpp"

/// Fastest relaxation rate of the contacts of a dense flow, held as they are, over k_d/m of small
/// disks. Measured in a steady state of CD_rot at phi = 0.82 (Z = 3.5), see docs/stability.md.
namespace bagnold::dense_flow {

inline constexpr Real rolling = 18.8;  ///< disks that roll, k_t = k_n
inline constexpr Real sliding = 8.0;   ///< disks that slide, k_t = k_n
inline constexpr Real normal = 5.3;    ///< k_t = 0

}  // namespace bagnold::dense_flow
