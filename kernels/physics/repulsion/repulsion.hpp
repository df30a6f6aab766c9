// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/math.hpp"

namespace bagnold {

/// Elastic repulsion along the normal, on i away from j, [m d_s / tau_e^2]; the input names it by
/// its exponent alpha.
///
///     f_el = (k_e / d_ij) (1 - r_ij / d_ij)^(alpha - 1)     P1 Eq. (2), P2 Eq. (2), with k_e = 1
template <class R>
concept RepulsionLaw = requires(R const repulsion, Contact<Real> const contact, Real overlap) {
  { R::force_exponent } -> std::convertible_to<double>;    // alpha
  { R::name } -> std::convertible_to<std::string_view>;    // beside alpha, in messages
  { R::stiffness(overlap) } -> std::convertible_to<Real>;  // -d f_el / d r_ij, [k_e / d_ij^2]
  { repulsion.magnitude(contact) } -> std::same_as<Real>;
};

/// alpha = 2, the papers' value.
struct HarmonicRepulsion {
  static constexpr double force_exponent = 2.0;
  static constexpr std::string_view name = "harmonic";

  static Real stiffness(Real) { return 1; }

  template <class T>
  KOKKOS_FUNCTION T magnitude(Contact<T> const& c) const {
    return c.relative_overlap * c.inverse_distance;
  }
};

/// alpha = 5/2, Hertz.
struct HertzianRepulsion {
  static constexpr double force_exponent = 2.5;
  static constexpr std::string_view name = "Hertz";

  static Real stiffness(Real relative_overlap) { return 1.5 * math::sqrt(relative_overlap); }

  template <class T>
  KOKKOS_FUNCTION T magnitude(Contact<T> const& c) const {
    using math::positive_part;  // packs bring their own
    using math::sqrt;
    T const overlap = positive_part(c.relative_overlap);  // rounding may leave -1e-16 at a touch
    return overlap * sqrt(overlap) * c.inverse_distance;
  }
};

/// All repulsions; the first is the default.
using Repulsions = std::tuple<HarmonicRepulsion,  //
                              HertzianRepulsion>;
static_assert(RepulsionLaw<HarmonicRepulsion> && RepulsionLaw<HertzianRepulsion>);

namespace detail {

template <class First, class... Other, class Use>
auto with_exponent(std::tuple<First, Other...> const*, double exponent, Use const& use) {
  if constexpr (sizeof...(Other) > 0)
    if (exponent != First::force_exponent)
      return with_exponent(static_cast<std::tuple<Other...> const*>(nullptr), exponent, use);
  return use(First{});
}

}  // namespace detail

/// Calls use(the repulsion of a force exponent alpha); the last one if there is none.
template <class Use>
auto with_repulsion(double exponent, Use const& use) {
  return detail::with_exponent(static_cast<Repulsions const*>(nullptr), exponent, use);
}

}  // namespace bagnold
