// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace bagnold::accuracy {

/// What numbers are kept in (positions, velocities), and what pairs are worked out in. Relative
/// positions and velocities are formed in the first and then rounded to the second.
struct DoublePrecision {
  static constexpr std::string_view name = "double";
  using Kept = double;
  using Pair = double;
};
struct FloatPairs {
  static constexpr std::string_view name = "float-pairs";
  using Kept = double;
  using Pair = float;
};
struct SinglePrecision {
  static constexpr std::string_view name = "float";
  using Kept = float;
  using Pair = float;
};

}  // namespace bagnold::accuracy
