// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "kernels/physics/multiply_add.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// One iteration of (1 + B) w = a, from u = w_k to w_k+1, for one component of a disk: coefficients
/// of a, -B u and u.
struct ChebyshevIteration {
  Real of_start, of_coupling, of_now;

  /// per_mass: factor from `force` to -B u; T: a number or pack, V: Vec2<T> or T.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION V operator()(V const& start, V const& force, T const& per_mass,
                                           V const& now) const {
    V const kept = multiply_add(T(of_now), now, T(of_start) * start);
    return multiply_add(T(of_coupling) * per_mass, force, kept);
  }
};

/// 1 - cos((2 j - 1) pi/(2 n)) of the roots of Chebyshev's polynomial T_n, in the order of the
/// iterations. Made on the host: the cosine of a device may differ in the last bit.
struct ChebyshevRoots {
  static constexpr int most = 9;
  int terms;  ///< n, 2 to most
  Real of[most];

  static ChebyshevRoots make(int terms) {
    ChebyshevRoots roots{terms, {}};
    for (int k = 0; k < terms; ++k) {
      int const j = k % 2 == 0 ? terms - k / 2 : k / 2 + 1;
      Real const angle = (2 * j - 1) * std::numbers::pi / (2 * terms);
      roots.of[k] = 1 - std::cos(angle);
    }
    return roots;
  }
};

/// Iterations of (1 + B) w = a for a B whose eigenvalues lie in [0, bound], Saad, Iterative Methods
/// (2nd ed.), Sec. 12.3.2: Richardson's, by the roots 1/g of Chebyshev's polynomial T_n,
///
///     w_k+1 = w_k + g_k (a - w_k - B w_k),   w_0 = 0,   k = 0 .. n - 1,
///     1/g = 1 + (bound/2) (1 - cos((2 j - 1) pi/(2 n))),   j = 1 .. n
///
/// No other polynomial of a and B with as many terms is nearer to the solution for the worst such
/// B: the error is 1/T_n(1 + 2/bound). Large and small roots alternate, so that rounding errors do
/// not grow. A component of a in the null space of B is multiplied by 1 less the error. The
/// momentum of all disks is conserved nevertheless, since pair forces give none to a.
///
/// w_1 is never computed: the first iteration takes `a` for u.
struct ChebyshevIterations {
  static constexpr int most = ChebyshevRoots::most - 1;
  ChebyshevIteration iteration[most];  ///< that make w_2, w_3 ...
  int count;                           ///< of them

  KOKKOS_FUNCTION ChebyshevIterations(Real bound, ChebyshevRoots const& roots)
      : iteration{}, count(roots.terms - 1) {
    auto const inverse_root = [&](int k) { return 1 / (1 + bound / 2 * roots.of[k]); };
    for (int k = 0; k < count; ++k) {
      Real const g = inverse_root(k + 1);
      iteration[k] = {g, g, 1 - g};
    }
    Real const first = inverse_root(0);
    iteration[0].of_coupling *= first;
    iteration[0].of_now *= first;
  }

  /// Iterations up to w_`terms`, 2 to most + 1, on the host.
  ChebyshevIterations(Real bound, int terms)
      : ChebyshevIterations(bound, ChebyshevRoots::make(terms)) {}
};

}  // namespace bagnold
