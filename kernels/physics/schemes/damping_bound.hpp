// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Bound for the rates at which damping relaxes the motions of disks in contact: the eigenvalues of
/// A, where A v = -f_dis(v)/m for all disks together.
///
/// A contact takes k |u_i + u_j|^2 out of the motion, u_i = v_i, or with the spin, v_i + (d_i/2)
/// thetadot_i t, at most twice k |u_i|^2 + k |u_j|^2. So the bound is the largest 2 k/m of
/// sum |u_i|^2 of any one disk: N contacts without spins; else
///
///     [(1 + mu) N + sqrt{(mu - 1)^2 N^2 + 4 mu S^2}] / 2,   mu = m d^2/(4 I),
///
/// S = |sum of the tangents t|, largest where contacts lie side by side, two small disks on a big
/// one an angle alpha apart, sin(alpha/2) = d_s/(d_s + d_b): S = |sin(N alpha/2) / sin(alpha/2)|.
class DampingBound {
 public:
  static constexpr int most = 12;  ///< contacts of a disk; there is no room for more

  template <ContactLaw Law>
  static DampingBound of(Law const& law, SpeciesTable const& table) {
    Real const normal = law.normal_damping(), tangential = law.tangential_damping();
    Real const damping = normal > tangential ? normal : tangential;
    DampingBound bound;
    for (Species s = 0; s < 2; ++s)
      for (int n = 0; n <= most; ++n)
        bound.rate_[s][n] = 2 * damping * table.inverse_mass[s] * effective(n, Law::rotates);
    return bound;
  }

  /// Bound for a disk with this number of contacts, [1/tau_e].
  KOKKOS_FUNCTION Real operator()(Species species, int contacts) const {
    return rate_[species][contacts < most ? contacts : most];
  }

 private:
  static Real effective(int n, bool rotates) {
    if (!rotates) return n;
    Real const mu = tangential_mobility(true) - 1;
    Real const half = std::asin(small_diameter / (small_diameter + big_diameter));
    Real const s = std::sin(n * half) / std::sin(half);
    return ((1 + mu) * n + std::sqrt((mu - 1) * (mu - 1) * n * n + 4 * mu * s * s)) / 2;
  }

  Real rate_[2][most + 1];
};

}  // namespace bagnold
