// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/rounded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bagnold {

namespace {

int power_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

/// Digits of an error, and the power of ten of the last one.
struct ErrorDigits {
  long digits;
  int last;

  explicit ErrorDigits(double error) : digits(0), last(power_of(error) - 1) {
    digits = std::lround(error / std::pow(10.0, last));  // 10 to 100
    if (digits < 20) return;
    digits = std::lround(error / std::pow(10.0, ++last));
  }
};

/// Power of ten of the text: numbers between 0.001 and 9999 are written out, unless the last digit
/// is of tens or more.
int shown_power(double mean, int last) {
  if (mean == 0) return last > 0 || last < -4 ? last : 0;
  int const power = std::max(power_of(mean), last);
  return power >= -3 && power <= 3 && last <= 0 ? 0 : power;
}

}  // namespace

std::string rounded(double mean, double error) {
  if (!std::isfinite(mean)) return "undefined";
  if (!std::isfinite(error) || !(error > 0)) return fmt::format("{:.4g}", mean);
  ErrorDigits const of(error);
  auto const write = [&](int power) {
    auto const [digits, last] = of;
    return fmt::format("{:.{}f}({}){}", mean / std::pow(10.0, power), power - last, digits,
                       power == 0 ? "" : fmt::format("e{}", power));
  };
  int const power = shown_power(mean, of.last);
  auto const text = write(power);
  bool const carried = power != 0 && (text.starts_with("10") || text.starts_with("-10"));
  return carried ? write(power + 1) : text;
}

std::string rounded_bias(double bias, double error) {
  return (bias < 0 ? "" : "+") + rounded(100 * bias, 100 * error);
}

}  // namespace bagnold
