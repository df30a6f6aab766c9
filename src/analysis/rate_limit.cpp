// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/rate_limit.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold::analysis {

namespace {

constexpr double standard_errors = 2;
constexpr double never = 1e300;

WithError ratio(AtTwoRates const& x) {
  double const value = x.half.value / x.whole.value;
  return {value,
          std::abs(value) * std::hypot(x.half.error / x.half.value, x.whole.error / x.whole.value)};
}

/// x = log2(whole / half), for the rate falls by two.
WithError exponent(AtTwoRates const& x) {
  WithError const r = ratio(x);
  return {-std::log2(r.value), r.error / std::abs(r.value) / std::log(2.0)};
}

Verdict verdict_of(WithError const& ratio, double tolerance) {
  double const off = std::abs(ratio.value - 1), spread = standard_errors * ratio.error;
  if (off + spread <= tolerance) return Verdict::holds;
  if (off - spread > tolerance) return Verdict::fails;
  return Verdict::undecided;
}

/// Errors fall as the root of the strain.
double longer_for(WithError const& ratio, double tolerance) {
  double const room = std::abs(tolerance - std::abs(ratio.value - 1));
  double const longer = std::pow(standard_errors * ratio.error / room, 2);
  return std::isfinite(longer) ? std::max(1.0, longer) : never;
}

Limit limit_of(std::string const& name, std::vector<std::string> const& quantities,
               std::map<std::string, AtTwoRates> const& found, double tolerance) {
  Limit limit{name, {}, Verdict::holds, 1};
  for (auto const& quantity : quantities) {
    WithError const r = ratio(found.at(quantity));
    limit.ratios[quantity] = r;
    Verdict const one = verdict_of(r, tolerance);
    if (one == Verdict::undecided) limit.longer = std::max(limit.longer, longer_for(r, tolerance));
    if (one == Verdict::fails || limit.verdict == Verdict::holds) limit.verdict = one;
  }
  if (limit.verdict != Verdict::undecided) limit.longer = 1;
  return limit;
}

}  // namespace

std::string_view word(Verdict verdict) {
  if (verdict == Verdict::holds) return "holds";
  return verdict == Verdict::fails ? "fails" : "undecided";
}

std::string RateLimit::verdict() const {
  for (auto const& limit : limits)
    if (limit.verdict == Verdict::holds) return limit.name;
  auto const fails = [](Limit const& limit) { return limit.verdict == Verdict::fails; };
  return std::ranges::all_of(limits, fails) ? "neither" : "undecided";
}

RateLimit rate_limit(std::map<std::string, AtTwoRates> const& found, double tolerance) {
  RateLimit result;
  result.limits = {limit_of("Bagnold", {"B_p", "B_sigma"}, found, tolerance),
                   limit_of("Newton", {"eta_p", "eta_sigma"}, found, tolerance)};
  for (auto const* stress : {"p", "sigma"}) result.exponents[stress] = exponent(found.at(stress));
  return result;
}

}  // namespace bagnold::analysis
