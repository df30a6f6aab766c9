// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <type_traits>

#include "kernels/blocks/blocks.hpp"
#include "kernels/contact/cd.hpp"
#include "kernels/contact/cd_n.hpp"
#include "kernels/contact/general.hpp"

namespace bagnold::accuracy {

/// k_d^n and k_d^t of a law.
template <ContactLaw Law>
Real normal_damping(Law const& law) {
  if constexpr (std::is_same_v<Law, General>)
    return law.damping_normal;
  else
    return law.damping;
}
template <ContactLaw Law>
Real tangential_damping(Law const& law) {
  if constexpr (std::is_same_v<Law, General>)
    return law.damping_tangential;
  else
    return std::is_same_v<Law, CDn> ? Real(0) : law.damping;
}

/// How a pair left to its damping alone slows down over a step, z = k dt/mu: v -> (1 - share) v.
enum class Relaxation { exact, implicit_midpoint, backward_euler };

inline Real share_lost(Relaxation relaxation, Real z) {
  if (relaxation == Relaxation::exact) return -std::expm1(-z);
  return z / (1 + (relaxation == Relaxation::implicit_midpoint ? z / 2 : z));
}

/// Impulse over relative velocity of a contact, [m]: J = -normal v_n n - tangential v_t, for each
/// class of pairs. With masses split in `parts` each, as if a disk had so many contacts alike.
///
///     1/mu = 1/m_i + 1/m_j;   tangential, rolling: 1/mu_t = 1/mu + (s_ji^2/I_i + s_ij^2/I_j),
///
/// at s_ji + s_ij = d_ij; that is 3/mu for I = m d^2/8.
struct PairRelaxation {
  Real normal[3], tangential[3];

  template <ContactLaw Law>
  PairRelaxation(Law const& law, SpeciesTable const& table, Relaxation relaxation, Real time,
                 Real parts = 1) {
    for (int big = 0; big < 3; ++big) {
      int const a = big == 2 ? 1 : 0, b = big == 0 ? 0 : 1;
      Real const inverse = (table.inverse_mass[a] + table.inverse_mass[b]) * parts;
      Real rolling = 0;
      if constexpr (Law::rotates)
        rolling = (table.diameter[a] * table.diameter[a] * table.inverse_inertia[a] +
                   table.diameter[b] * table.diameter[b] * table.inverse_inertia[b]) /
                  4 * parts;
      normal[big] = share_lost(relaxation, normal_damping(law) * time * inverse) / inverse;
      tangential[big] = share_lost(relaxation, tangential_damping(law) * time * (inverse + rolling)) /
                        (inverse + rolling);
    }
  }
};

}  // namespace bagnold::accuracy
