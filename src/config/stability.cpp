// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/abilities.hpp"
#include "src/config/contact_rates.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

/// The larger spectral radius of the normal and of the tangential motion.
template <class S>
double spectral_radius(S scheme, ContactRates const& r, double time_step) {
  return std::max(ContactMatrix::of(scheme, {r.stiffness, r.normal}, time_step).radius(),
                  std::abs(ContactMatrix::of(scheme, {0, r.tangential}, time_step).vv));
}

}  // namespace

double contact_spectral_radius(Scene const& scene, std::string_view scheme, double time_step) {
  ContactRates const r(scene);
  return with_named<Schemes>(
      scheme, [&]<class S>(std::type_identity<S>) { return spectral_radius(S{}, r, time_step); });
}

double contact_spectral_radius(Scene const& scene, double time_step) {
  return contact_spectral_radius(scene, scheme_of(scene), time_step);
}

double largest_stable_time_step(Scene const& scene, std::string_view scheme) {
  if (is_scheme_of_an_engine(scheme)) return std::numeric_limits<double>::infinity();
  constexpr double contacts = 6;
  ContactRates const r(scene);
  double const rate = contacts * std::max(r.normal, r.tangential) + drag_rate(scene);
  double const stiffness = contacts * r.stiffness;
  return with_named<Schemes>(scheme, [&]<class S>(std::type_identity<S>) -> double {
    if constexpr (ImplicitScheme<S>)  // damping across contacts does not hold what they spring
      return S::largest_time_step(contacts * r.normal + drag_rate(scene), stiffness);
    else
      return std::min(S::largest_rate / rate, S::largest_frequency / std::sqrt(stiffness));
  });
}

double dense_flow_time_step(Scene const& scene, std::string_view scheme) {
  if (is_scheme_of_an_engine(scheme)) return std::numeric_limits<double>::infinity();
  ContactRates const r(scene);
  return with_named<Schemes>(scheme, [&]<class S>(std::type_identity<S>) -> double {
    if constexpr (ImplicitScheme<S>)  // stable for any damping alone: springs decide
      return S::largest_time_step(r.network * r.normal + drag_rate(scene), r.network * r.stiffness);
    else
      return S::largest_rate / (r.dense_flow + drag_rate(scene));
  });
}

}  // namespace bagnold
