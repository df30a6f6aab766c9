// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/collision_loss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/contact_rates.hpp"

namespace bagnold {

namespace {

constexpr int phases = 32;
constexpr double longest = 10;  ///< half periods after which what is left is lost, or 40/c

/// Share of the energy that is lost; `phase`: of a step before the contact begins.
template <class S>
double loss(S, LoneContact const& contact, double h, double phase, double half_period) {
  RelativeMotion q{phase * h, -1};
  double const end = std::min(longest * half_period, 40 / contact.damping) + 2 * h;
  for (double t = 0; t < end && std::isfinite(q.x); t += h) {
    q = S::step(q, contact, h);
    if (q.x >= 0 && q.v > 0) return 1 - q.v * q.v;
  }
  return 1;
}

}  // namespace

double collision_loss_error(Scene const& scene, std::string_view scheme, double time_step) {
  ContactRates const r(scene);
  double const decay = r.normal / 2, squared = r.stiffness - decay * decay;
  if (!r.harmonic || decay == 0 || squared <= 0) return 0;
  double const half_period = std::numbers::pi / std::sqrt(squared);
  LoneContact const contact{r.stiffness, r.normal, true};
  double sum = 0;
  with_named<Schemes>(scheme, [&]<class S>(std::type_identity<S>) {
    for (int k = 0; k < phases; ++k)
      sum += loss(S{}, contact, time_step, (k + 0.5) / phases, half_period);
  });
  return sum / phases / -std::expm1(-2 * decay * half_period) - 1;
}

}  // namespace bagnold
