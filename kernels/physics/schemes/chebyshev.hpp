// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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

/// 1 - x of the zeros x of T_n(x) + s, T_n: Chebyshev's polynomial, s: the lift, in the order of
/// the iterations. Made on the host: the cosine of a device may differ in the last bit.
struct ChebyshevRoots {
  static constexpr int most = 9;
  int terms;  ///< n, 2 to most
  Real of[most];

  /// lift: 0 to 1.
  static ChebyshevRoots make(int terms, Real lift) {
    Real rising[most];
    for (int j = 0; j < terms; ++j)
      rising[j] = 1 - std::cos((std::acos(-lift) + 2 * j * std::numbers::pi) / terms);
    std::sort(rising, rising + terms);
    ChebyshevRoots roots{terms, {}};
    for (int k = 0; k < terms; ++k) roots.of[k] = rising[k % 2 == 0 ? terms - 1 - k / 2 : k / 2];
    return roots;
  }
};

/// Iterations of (1 + B) w = a for a B whose eigenvalues lie in [0, bound], Saad, Iterative Methods
/// (2nd ed.), Sec. 12.3.2: Richardson's, by the roots 1/g of a polynomial,
///
///     w_k+1 = w_k + g_k (a - w_k - B w_k),   w_0 = 0,   k = 0 .. n - 1,
///     1/g = 1 + (bound/2) (1 - x),           T_n(x) = -s
///
/// They leave of a component of `a` with the eigenvalue b the part
///
///     [T_n(1 - 2 b/bound) + s] / [T_n(1 + 2/bound) + s],
///
/// from -(1 - s) to 1 + s of 1/(T_n(1 + 2/bound) + s). With s = 0 no other polynomial of as many
/// terms is nearer to the solution for the worst such B. With s > 0 the part that is taken too far,
/// below 0, is smaller and the other larger (why: ImplicitDamping::lift). Large and small roots
/// alternate, so that rounding errors do not grow. A component in the null space of B is multiplied
/// by 1 less its part. The momentum of all disks is conserved nevertheless, since pair forces give
/// none to a.
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
  ChebyshevIterations(Real bound, int terms, Real lift)
      : ChebyshevIterations(bound, ChebyshevRoots::make(terms, lift)) {}
};

}  // namespace bagnold
