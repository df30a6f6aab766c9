// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bagnold::analysis {

/// A number with one standard deviation; infinite where it is not known.
struct WithError {
  double value = 0;
  double error = 0;
};

/// A quantity at a strain rate and at half of it.
struct AtTwoRates {
  WithError whole, half;
};

enum class Verdict { holds, fails, undecided };
std::string_view word(Verdict verdict);

/// Test that quantities which a limit gammadot -> 0 leaves constant are the same at a rate and at
/// half of it. In the hard-core limit of Bagnold's rheology these are B_p and B_sigma of P1 Eq.
/// (16) (P1 Fig. 1); in Newton's limit eta_p and eta_sigma of P2 Eq. (20) (P2 Sec. III A).
struct Limit {
  std::string name;                         ///< "Bagnold" or "Newton"
  std::map<std::string, WithError> ratios;  ///< by quantity: at half the rate over at the rate
  Verdict verdict = Verdict::undecided;
  double longer =
      1;  ///< where undecided: how many times the strain would decide; 1e300: none known
};

struct RateLimit {
  std::vector<Limit> limits;  ///< Bagnold, Newton
  std::map<std::string, WithError>
      exponents;  ///< x of p ~ gammadot^x and sigma ~ gammadot^x; 2: Bagnold

  /// "Bagnold" or "Newton", the limit that holds; "neither" where both fail; "undecided".
  std::string verdict() const;
};

/// Compares B_p, B_sigma, eta_p, eta_sigma, p and sigma at both rates. A limit holds where all its
/// ratios are within 1 +- tolerance by two standard errors, and fails where one is outside by as
/// much. A measurement too short to decide is never taken for a proof.
RateLimit rate_limit(std::map<std::string, AtTwoRates> const& found, double tolerance);

}  // namespace bagnold::analysis
