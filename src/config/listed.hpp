// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace bagnold {

/// True if a law and a drive are those of the lists (kernels/physics/laws/laws.hpp, drives.hpp), so
/// that `bagnold` has them too; false for one that a user's program has registered.
bool is_listed(std::string_view law, std::string_view drive);

}  // namespace bagnold
