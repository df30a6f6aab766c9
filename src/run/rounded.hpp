// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

/// A mean with the standard error of its last digits in brackets, 1.89(10)e4 for 18900 +- 1000, as
/// in the pictures: of the error one digit, two where the first is a 1. "undefined" for a mean that
/// is not finite; four digits and no brackets where the error is none, 0 or not finite.
std::string rounded(double mean, double error);

}  // namespace bagnold
