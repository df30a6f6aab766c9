// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/analysis/fit/chance.hpp"
#include "src/analysis/fit/fit.hpp"
#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/statistics/student.hpp"

namespace bagnold::analysis {
namespace {

constexpr std::size_t fewest_seeds = 3;  ///< whose scatter tells the error of a ratio

std::vector<double> at(std::vector<double> const& all, std::span<std::size_t const> rows) {
  std::vector<double> out;
  for (auto const row : rows) out.push_back(all[row]);
  return out;
}

Measured const& observable(SweepTable const& table, std::string const& name) {
  if (auto const found = table.observables.find(name); found != table.observables.end())
    return found->second;
  std::vector<std::string> known;
  for (auto const& [other, values] : table.observables) known.push_back(other);
  throw InputError(fmt::format("{} (no such observable or key in {}); perhaps {}. There are: {}",
                               name, table.origin, nearest_word(name, known),
                               fmt::join(known, " ")));
}

}  // namespace

Value merge_seeds(std::span<double const> means, std::span<double const> errors) {
  double sum = 0.0, squares = 0.0, scatter = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (!std::isfinite(means[i])) continue;
    ++count;
    sum += means[i];
    squares += errors[i] * errors[i];  // NaN where one is not known: then so is the sum
  }
  if (count == 0) return {unknown, unknown};
  double const n = static_cast<double>(count), mean = sum / n;
  for (double const value : means)
    if (std::isfinite(value)) scatter += (value - mean) * (value - mean);
  double const own = std::sqrt(squares) / n;
  if (count == 1) return {mean, own};
  bool const by_chance = scatter / n <= chance_limit(n - 1.0) * own * own;  // NaN compares false
  return {mean, by_chance
                    ? own
                    : statistics::student_factor(count - 1) * std::sqrt(scatter / (n * (n - 1.0)))};
}

Quantity::Quantity(SweepTable const& table, std::string const& name, std::optional<double> phi_j)
    : name_(name) {
  if (auto const sign = name.find_last_of("*/"); sign != std::string::npos) {
    first_ = std::make_shared<Quantity>(table, name.substr(0, sign), phi_j);
    second_ = std::make_shared<Quantity>(table, name.substr(sign + 1), phi_j);
    divides_ = name[sign] == '/';
  } else if (name == "phi_J-phi") {
    if (!phi_j) throw InputError("phi_J-phi needs phi_J; give --phi-j, 0.84335 in P1");
    number_ = table.numbers("disks.packing_fraction");
    for (double& phi : number_) phi = *phi_j - phi;
  } else if (name.find('.') != std::string::npos) {
    number_ = table.numbers(name);
  } else {
    observable_ = &observable(table, name);
    errors_ = seed_errors(table, *observable_);
  }
}

/// Merged over seeds; a seed without an error has the pooled one.
Value Quantity::measured(std::span<std::size_t const> rows) const {
  auto const means = at(observable_->mean, rows);
  auto errors = at(observable_->error, rows);
  bool pooled = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::isfinite(errors[i])) {
      errors[i] *= errors_.factor;
    } else if (std::isfinite(means[i])) {
      errors[i] = errors_.relative * std::abs(mean(rows));
      pooled = std::isfinite(errors[i]);
    }
  }
  auto out = merge_seeds(means, errors);
  out.pooled = pooled;
  return out;
}

double Quantity::mean(std::span<std::size_t const> rows) const {
  if (first_) {
    double const first = first_->mean(rows), second = second_->mean(rows);
    return divides_ ? first / second : first * second;
  }
  if (!observable_) return rows.empty() ? unknown : number_[rows.front()];
  double sum = 0.0, count = 0.0;
  for (auto const row : rows)
    if (std::isfinite(observable_->mean[row])) sum += observable_->mean[row], count += 1.0;
  return sum / count;
}

double Quantity::error_of_seeds(std::span<std::size_t const> rows) const {
  std::vector<std::size_t> seeds;
  for (auto const row : rows)
    if (std::isfinite(mean({&row, 1}))) seeds.push_back(row);
  if (seeds.size() < fewest_seeds) return unknown;
  std::vector<double> without;
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    auto others = seeds;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    without.push_back(mean(others));
  }
  double const n = static_cast<double>(seeds.size());
  double const middle = std::accumulate(without.begin(), without.end(), 0.0) / n;
  double squares = 0.0;
  for (double const value : without) squares += (value - middle) * (value - middle);
  return statistics::student_factor(seeds.size() - 1) * std::sqrt((n - 1.0) / n * squares);
}

double Quantity::widened() const {
  return first_ ? std::max(first_->widened(), second_->widened()) : errors_.factor;
}

Value Quantity::of(std::span<std::size_t const> rows) const {
  if (first_) {
    auto const first = first_->of(rows), second = second_->of(rows);
    bool const pooled = first.pooled || second.pooled;
    if (first_->is_measured() && second_->is_measured()) {
      double const error = error_of_seeds(rows);
      if (std::isfinite(error)) return {mean(rows), error};
    }
    if (!divides_)
      return {first.mean * second.mean,
              std::hypot(first.error * second.mean, first.mean * second.error), pooled};
    double const ratio = first.mean / second.mean;
    return {ratio, std::hypot(first.error / second.mean, ratio * second.error / second.mean),
            pooled};
  }
  if (observable_) return measured(rows);
  return {rows.empty() ? unknown : number_[rows.front()], 0.0};
}

double Quantity::resampled(std::span<std::size_t const> rows, Draw const& draw) const {
  if (draw.replica == 0 || is_key()) return of(rows).mean;
  if (first_) {
    double const first = first_->resampled(rows, draw), second = second_->resampled(rows, draw);
    return divides_ ? first / second : first * second;
  }
  if (rows.size() == 1) {
    auto const measured = of(rows);
    return measured.mean +
           (std::isfinite(measured.error) ? measured.error : 0.0) * random_normal(draw, name_);
  }
  std::vector<std::size_t> drawn;
  for (std::uint32_t k = 0; k + 1 < rows.size(); ++k)
    drawn.push_back(rows[random_index(draw, k, rows.size())]);
  return of(drawn).mean;
}

}  // namespace bagnold::analysis
