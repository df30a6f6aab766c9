// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace bagnold {

/// What is wrong with a value that is written as other languages, or people, write it, and how it
/// is written here: "a number has its decimals behind a point; write 40.0" of 40,0. "" where
/// nothing is known of it. Text behind `#` and blanks at the ends do not count.
std::string value_advice(std::string_view value);

}  // namespace bagnold
