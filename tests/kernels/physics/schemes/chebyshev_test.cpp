// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/schemes/chebyshev.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bagnold::test {
namespace {

/// w of (1 + b) w = 1, one number.
Real solved(Real b, Real bound, int terms) {
  ChebyshevIterations const plan(bound, terms);
  Real now = 1;  // a in the place of w_1
  for (int k = 0; k < plan.count; ++k) now = plan.iteration[k](Real(1), -now, b, now);
  return now;
}

/// The residual 1 - (1 + b) w is T_k(1 - 2 b/bound)/T_k(1 + 2/bound), T_k(x) = cos(k acos x).
TEST(Chebyshev, LeavesItsPolynomial) {
  for (Real const bound : {0.1, 3.0, 28.8})
    for (int terms = 2; terms <= 1 + ChebyshevIterations::most; ++terms) {
      Real const outside = 1 + 2 / bound;
      Real const largest = std::cosh(terms * std::acosh(outside));
      for (int k = 0; k <= 20; ++k) {
        Real const b = bound * k / 20, x = std::clamp(1 - 2 * b / bound, -1.0, 1.0);
        Real const left = 1 - (1 + b) * solved(b, bound, terms);
        EXPECT_NEAR(left, std::cos(terms * std::acos(x)) / largest, 1e-13)
            << bound << ' ' << terms << ' ' << b;
      }
    }
}

TEST(Chebyshev, SolvesAtOnceWhatIsNotCoupled) {
  for (int terms = 2; terms <= 1 + ChebyshevIterations::most; ++terms)
    EXPECT_NEAR(solved(0, 0, terms), 1, 1e-15);
}

}  // namespace
}  // namespace bagnold::test
