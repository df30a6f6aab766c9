// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace bagnold {

/// Kind of value that a key takes: true or false, an integer, any number, or any of them.
enum class Wanted { anything, choice, whole, number };

/// Correction of a value written as in other languages: for 40,0 "a number has its decimals behind
/// a point; write 40.0". "" if the mistake is not known. Ignores text behind `#` and blanks at the
/// ends.
std::string value_advice(std::string_view value, Wanted wanted = Wanted::anything);

}  // namespace bagnold
