// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace bagnold {

/// The longest run: its steps are counted exactly in a double, with room to spare.
inline constexpr double most_steps = 4e15;

/// A quotient rounded up, except for its rounding error.
inline double round_up(double quotient) { return std::ceil(quotient * (1 - 1e-12)); }

}  // namespace bagnold
