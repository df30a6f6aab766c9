// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/judge.hpp"

#include <algorithm>
#include <cmath>

#include "src/config/ladder.hpp"
#include "src/statistics/student.hpp"

namespace bagnold::bias {

namespace {

constexpr double floor_error = 2e-4;     ///< of an average over a stretch
constexpr double gas_strain = 0.1;       ///< of relaxation, above which a flow is a gas
constexpr double temperature_share = 3;  ///< its tolerance over that of p

/// Share of a bias that builds up beyond a stretch. Z of quasi-static steps of CD_rot at 1e-6 still
/// grows by 0.8, 0.5 and 0.3 of what it is after 0.0075, 0.015 and 0.03.
double still_to_come(double strain) {
  return 0.5 * std::sqrt(std::max(1.0, stretch_strain / strain));
}

/// A quantity of all pairs.
struct Series {
  std::vector<double> coarse, fine;

  Series(std::span<Pair const> pairs, double Averages::*quantity) {
    for (auto const& pair : pairs) {
      coarse.push_back(pair.coarse.*quantity);
      fine.push_back(pair.fine.*quantity);
    }
  }
};

double sum(std::vector<double> const& of) {
  double all = 0;
  for (double const one : of) all += one;
  return all;
}

/// Relative bias of a ratio of sums, and what it leaves of each pair, relative to the mean.
struct Ratio {
  double bias;
  std::vector<double> rest;

  explicit Ratio(Series const& of) : bias(sum(of.coarse) / sum(of.fine) - 1) {
    double const mean = sum(of.fine) / static_cast<double>(of.fine.size());
    for (std::size_t k = 0; k < of.fine.size(); ++k)
      rest.push_back((of.coarse[k] - (1 + bias) * of.fine[k]) / mean);
  }
};

/// Standard error of a mean with these deviations from it, with the floor.
double standard_error(std::vector<double> const& rest) {
  auto const m = static_cast<double>(rest.size());
  double squares = 0;
  for (double const r : rest) squares += r * r;
  return std::hypot(std::sqrt(squares / (m * (m - 1))), floor_error);
}

Bias bias_from(double value, std::vector<double> const& rest) {
  auto const freedom = rest.size() - 1;
  double const error = standard_error(rest);
  return {value, statistics::student_quantile(freedom) * error,
          statistics::student_factor(freedom) * error};
}

/// Relative bias of T_g in the end, by its slope over the strain.
Bias slope_of_temperature(std::span<Pair const> pairs, double strain, double relaxation) {
  double fine = 0, all = 0;
  for (auto const& pair : pairs) fine += pair.fine.temperature / static_cast<double>(pairs.size());
  std::vector<double> slopes;
  double const distance = strain / 2;  // between the middles of the first third and of the others
  for (auto const& [step, c, f] : pairs)
    slopes.push_back(
        ((c.temperature - f.temperature) - (c.temperature_before - f.temperature_before)) / fine /
        distance * relaxation);
  all = sum(slopes) / static_cast<double>(slopes.size());
  for (double& slope : slopes) slope -= all;
  return bias_from(all, slopes);
}

/// Adds a share of the bias of T_g.
Bias with_temperature(Bias of, Bias const& temperature, double share) {
  of.value += share * temperature.value;
  of.error = std::hypot(of.error, share * temperature.error);
  return of;
}

Verdict verdict_of(Judgement const& of, double tolerance, double still_to_come,
                   double collision_loss_error) {
  auto const& b = of.judged;
  double const of_temperature = of.gas ? tolerance : temperature_share * tolerance;
  auto const exceeds = [&](Quantity q, double bound) {
    return std::abs(b[q].value) - b[q].bound > bound;
  };
  if (of.gas && !(std::abs(collision_loss_error) < tolerance)) return Verdict::refused;
  for (auto const q : {pressure, shear_stress, contact_number})
    if (exceeds(q, tolerance)) return Verdict::refused;
  if (exceeds(temperature, of_temperature)) return Verdict::refused;
  double const t = std::abs(b[temperature].value);
  if (of.gas) return t + b[temperature].bound < tolerance ? Verdict::accepted : Verdict::none;
  for (auto const q : {pressure, shear_stress, contact_number})
    if (!((1 + still_to_come) * std::abs(b[q].value) + b[q].bound < tolerance))
      return Verdict::none;
  return t < of_temperature ? Verdict::accepted : Verdict::none;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view names[] = {"none", "accepted", "refused", "open", "usual"};
  return names[static_cast<std::size_t>(verdict)];
}

Judgement judge(std::span<Pair const> pairs, double tolerance, double strain,
                double collision_loss_error) {
  Judgement of;
  Ratio const p(Series(pairs, &Averages::p)), sigma(Series(pairs, &Averages::sigma)),
      z(Series(pairs, &Averages::contact_number)), t(Series(pairs, &Averages::temperature));
  double const relaxation = 2 * sum(Series(pairs, &Averages::kinetic_pressure).coarse) /
                            sum(Series(pairs, &Averages::sigma).coarse);
  of.gas = relaxation > gas_strain;
  auto& b = of.judged;
  b[pressure] = bias_from(p.bias, p.rest);
  b[shear_stress] = bias_from(sigma.bias, sigma.rest);
  b[contact_number] = bias_from(z.bias, z.rest);
  b[temperature] =
      of.gas ? slope_of_temperature(pairs, strain, relaxation) : bias_from(t.bias, t.rest);
  auto apart = sigma.rest;
  for (std::size_t k = 0; k < apart.size(); ++k) apart[k] -= p.rest[k];
  b[friction] = bias_from((1 + sigma.bias) / (1 + p.bias) - 1, apart);
  double const growth = still_to_come(strain);
  of.verdict = verdict_of(of, tolerance, growth, collision_loss_error);

  of.stated = b;
  if (of.gas) {
    constexpr std::array<double, quantities> share = {1, 0.5, 0.5, 0, -0.5};
    for (std::size_t q = 0; q < quantities; ++q)
      of.stated[q] = with_temperature(b[q], b[temperature], share[q]);
  }
  for (auto& one : of.stated) one.error = std::hypot(one.error, growth * one.value);
  return of;
}

}  // namespace bagnold::bias
