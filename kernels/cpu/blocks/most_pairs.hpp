// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace bagnold {

/// Largest number of pairs in the lists of all blocks: places in lists are 32-bit numbers.
inline constexpr std::uint64_t most_pairs = std::uint64_t{1} << 32;

}  // namespace bagnold
