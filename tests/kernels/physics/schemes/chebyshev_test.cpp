// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/schemes/chebyshev.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bagnold::test {
namespace {

/// w of (1 + b) w = 1, one number.
Real solved(Real b, Real bound, int terms, Real lift) {
  ChebyshevIterations const plan(bound, terms, lift);
  Real now = 1;  // a in the place of w_1
  for (int k = 0; k < plan.count; ++k) now = plan.iteration[k](Real(1), -now, b, now);
  return now;
}

/// The residual 1 - (1 + b) w is [T_k(1 - 2 b/bound) + s]/[T_k(1 + 2/bound) + s], T_k(x) = cos(k
/// acos x).
TEST(Chebyshev, LeavesItsPolynomial) {
  for (Real const bound : {0.1, 3.0, 28.8, 60.0})
    for (Real const lift : {0.0, 0.5, 1.0})
      for (int terms = 2; terms <= 1 + ChebyshevIterations::most; ++terms) {
        Real const largest = std::cosh(terms * std::acosh(1 + 2 / bound));
        for (int k = 0; k <= 20; ++k) {
          Real const b = bound * k / 20, x = std::clamp(1 - 2 * b / bound, -1.0, 1.0);
          Real const left = 1 - (1 + b) * solved(b, bound, terms, lift);
          EXPECT_NEAR(left, (std::cos(terms * std::acos(x)) + lift) / (largest + lift), 1e-13)
              << bound << ' ' << lift << ' ' << terms << ' ' << b;
        }
      }
}

TEST(Chebyshev, SolvesAtOnceWhatIsNotCoupled) {
  for (int terms = 2; terms <= 1 + ChebyshevIterations::most; ++terms)
    EXPECT_NEAR(solved(0, 0, terms, 0.5), 1, 1e-15);
}

}  // namespace
}  // namespace bagnold::test
