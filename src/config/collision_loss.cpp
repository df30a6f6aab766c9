// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/collision_loss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/config/contact_rates.hpp"
#include "src/config/stability.hpp"

namespace bagnold {

namespace {

constexpr int phases = 32;
constexpr double longest = 10;  ///< half periods after which what is left is lost, or 40/c

/// Two disks on a line: x < 0 is overlap.
struct Pair {
  double k, c, x, v;

  double acceleration(double at, double velocity) const {
    return at < 0 ? -k * at - c * velocity : 0.0;
  }

  /// P2 Eqs. (21)-(24).
  void papers_step(double h) {
    double const first = acceleration(x, v);
    double const second = acceleration(x + h * v, v + h * first);
    double const after = v + h / 2 * (first + second);
    x += h / 2 * (v + after);
    v = after;
  }

  /// docs/accuracy.md, "Two-stage".
  void two_stage_step(double h) {
    double const change = h * acceleration(x, v);
    double const damped = x < 0 ? second_stage_share(h * c) * h * c : 0.0;
    v += change - damped * change;
    x += h * v;
  }
};

/// Share of the energy that is lost; `phase`: of a step before the contact begins.
double loss(Pair pair, std::string_view scheme, double h, double phase, double half_period) {
  pair.x = phase * h;
  pair.v = -1;
  double const end = std::min(longest * half_period, 40 / pair.c) + 2 * h;
  for (double t = 0; t < end && std::isfinite(pair.x); t += h) {
    scheme == two_stage_scheme ? pair.two_stage_step(h) : pair.papers_step(h);
    if (pair.x >= 0 && pair.v > 0) return 1 - pair.v * pair.v;
  }
  return 1;
}

}  // namespace

double collision_loss_error(Scene const& scene, std::string_view scheme, double time_step) {
  ContactRates const r(scene);
  double const decay = r.normal / 2, squared = r.stiffness - decay * decay;
  if (scene.disks.force_exponent != 2.0 || decay == 0 || squared <= 0) return 0;
  double const half_period = std::numbers::pi / std::sqrt(squared);
  double sum = 0;
  for (int k = 0; k < phases; ++k)
    sum += loss({r.stiffness, r.normal, 0, 0}, scheme, time_step, (k + 0.5) / phases, half_period);
  return sum / phases / -std::expm1(-2 * decay * half_period) - 1;
}

}  // namespace bagnold
