// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace bagnold {

/// Text from outside as a message repeats it: one line without control characters, the beginning of
/// what is long.
std::string shown(std::string_view text);

}  // namespace bagnold
