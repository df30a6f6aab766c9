// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/multiply_add.hpp"
#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// One iteration of (1 + B) w = a, from u = w_k and w_k-1 to w_k+1; coefficients of a, -B u, u and
/// w_k-1. Of one component of a disk.
struct ChebyshevIteration {
  Real of_start, of_coupling, of_now, of_before;

  /// per_mass: what makes -B u of `force`; T: a number or pack, V: Vec2<T> or T.
  template <class T, class V>
  KOKKOS_FORCEINLINE_FUNCTION V operator()(V const& start, V const& force, T const& per_mass,
                                           V const& now, V const& before) const {
    V const sum = multiply_add(T(of_now), now, T(of_before) * before);
    return multiply_add(T(of_start), start, multiply_add(T(of_coupling) * per_mass, force, sum));
  }
};

/// The iterations of (1 + B) w = a for a B whose eigenvalues lie in [0, bound], Golub and Van Loan,
/// Matrix Computations (4th ed.), Sec. 11.2.8:
///
///     w_1 = g a,   w_k+1 = w_k-1 + omega_k [g (a - w_k - B w_k) + w_k - w_k-1],   w_0 = 0
///     g = 2/(2 + bound),   q = bound/(2 + bound),
///     omega_1 = 1/(1 - q^2/2),   omega_k+1 = 1/(1 - omega_k q^2/4)
///
/// No other polynomial of a and B with as many terms is nearer to the solution for the worst of
/// such B: an error of 1/T_k(1 + 2/bound). What B takes for zero, such as a motion of all disks, is
/// solved exactly in the first, and its sum over disks kept by all.
///
/// w_1 is never worked out: the first iteration takes `a` for u and both, the second for w_1.
struct ChebyshevIterations {
  static constexpr int most = 8;
  ChebyshevIteration iteration[most];  ///< that make w_2, w_3 ...
  int count;                           ///< of them

  /// To w_`terms`, 2 to most + 1.
  KOKKOS_FUNCTION ChebyshevIterations(Real bound, int terms) : iteration{}, count(terms - 1) {
    Real const g = 2 / (2 + bound), q = bound / (2 + bound), q2 = q * q;
    Real omega = 1 / (1 - q2 / 2);
    for (int k = 0; k < count; ++k) {
      iteration[k] = {omega * g, omega * g, omega - omega * g, 1 - omega};
      omega = 1 / (1 - omega * q2 / 4);
    }
    iteration[0].of_coupling *= g;
    iteration[0].of_now *= g;
    iteration[0].of_before = 0;
    if (count > 1) iteration[1].of_before *= g;
  }
};

}  // namespace bagnold
