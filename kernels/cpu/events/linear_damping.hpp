// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"

namespace bagnold::events {

/// Any law that is linear in the velocity, by its two constants.
///
///     f_dis = -k_n (v . n) n - k_t [v - (v . n) n]
///
/// Force on i from j, [m d_s / tau_e^2].
template <bool Rotates>
struct LinearDamping {
  static constexpr bool rotates = Rotates;
  Real normal;      ///< k_n, [m / tau_e]
  Real tangential;  ///< k_t, [m / tau_e]

  template <class T>
  Vec2<T> dissipative_force(Contact<T> const& c) const {
    T const along = T(tangential - normal) * dot(c.velocity, c.normal);
    return along * c.normal - T(tangential) * c.velocity;
  }
};
static_assert(PairLaw<LinearDamping<false>> && PairLaw<LinearDamping<true>>);

}  // namespace bagnold::events
