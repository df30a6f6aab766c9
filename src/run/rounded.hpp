// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

/// Mean with the standard error of its last digits in brackets, 1.89(10)e4 for 18900 +- 1000, as in
/// the pictures: one digit of the error, two if the first is a 1. "undefined" for a mean that is
/// not finite; four digits and no brackets if there is no error, or it is 0 or not finite.
std::string rounded(double mean, double error);

/// Relative bias in per cent with its sign and error: "+0.02(3)".
std::string rounded_bias(double bias, double error);

}  // namespace bagnold
