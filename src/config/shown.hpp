// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace bagnold {

/// Text of a user for a message: one line without control characters, cut if it is long.
std::string shown(std::string_view text);

}  // namespace bagnold
