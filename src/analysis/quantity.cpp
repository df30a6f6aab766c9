// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "src/analysis/fit/chance.hpp"
#include "src/analysis/fit/fit.hpp"
#include "src/analysis/run_ratios.hpp"
#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/statistics/jackknife.hpp"
#include "src/statistics/replicas.hpp"
#include "src/statistics/student.hpp"

namespace bagnold::analysis {
namespace {

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
  throw InputError(fmt::format("{} (no such observable or key in {}){} There are: {}", name,
                               table.origin, did_you_mean(name, known, "."),
                               fmt::join(known, " ")));
}

/// True if each name of a ratio or product is there to work it out from.
bool has_parts(SweepTable const& table, std::string const& name) {
  auto const sign = name.find_last_of("*/");
  if (sign != std::string::npos)
    return has_parts(table, name.substr(0, sign)) && has_parts(table, name.substr(sign + 1));
  return table.observables.contains(name) || table.keys.contains(name) || name == "phi_J-phi";
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
    : name_(name), table_(&table) {
  auto const sign = name.find_last_of("*/");
  bool const is_column = table.observables.contains(name) && !has_parts(table, name);
  if (sign != std::string::npos && !is_column) {
    first_ = std::make_shared<Quantity>(table, name.substr(0, sign), phi_j);
    second_ = std::make_shared<Quantity>(table, name.substr(sign + 1), phi_j);
    divides_ = name[sign] == '/';
  } else if (name == "phi_J-phi") {
    if (!phi_j) throw InputError("phi_J-phi needs phi_J; give --phi-j, 0.84335 in P1");
    if (table.observables.contains("packing_fraction"))
      throw InputError(
          "phi_J-phi is of disks.packing_fraction, at given pressure that of the start alone; take "
          "packing_fraction, which is measured there");
    number_ = table.numbers("disks.packing_fraction");
    for (double& phi : number_) phi = *phi_j - phi;
  } else if (analysis::is_key(name)) {
    number_ = table.numbers(name);
  } else {
    observable_ = &observable(table, name);
    errors_ = seed_errors(table, *observable_);
    if (auto const bias = table.observables.find(name + "_bias"); bias != table.observables.end())
      bias_ = &bias->second;
  }
}

/// Merged over seeds; a seed without an error has the pooled one.
Value Quantity::measured(Measured const& observable, SeedErrors const& pool,
                         std::span<std::size_t const> rows) const {
  auto const means = at(observable.mean, rows);
  auto errors = at(observable.error, rows);
  double sum = 0.0, count = 0.0;
  for (double const value : means)
    if (std::isfinite(value)) sum += value, count += 1.0;
  bool pooled = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::isfinite(errors[i])) {
      errors[i] *= pool.factor;
    } else if (std::isfinite(means[i])) {
      errors[i] = pool.relative * std::abs(sum / count);
      pooled = std::isfinite(errors[i]);
    }
  }
  auto out = merge_seeds(means, errors);
  out.pooled = pooled;
  return out;
}

void Quantity::add_parts(std::vector<Quantity const*>& parts) const {
  if (!first_) return parts.push_back(this);
  first_->add_parts(parts);
  second_->add_parts(parts);
}

double Quantity::of_parts(std::span<double const>& means) const {
  if (!first_) {
    double const mean = means.front();
    means = means.subspan(1);
    return mean;
  }
  double const first = first_->of_parts(means), second = second_->of_parts(means);
  return divides_ ? first / second : first * second;
}

double Quantity::error_of_seeds(std::span<std::size_t const> rows) const {
  std::vector<Quantity const*> parts;
  add_parts(parts);
  statistics::Windows seeds{parts.size(), {}, {}};
  for (auto const row : rows) {
    std::vector<double> means;
    for (auto const* part : parts)
      means.push_back((part->observable_ ? part->observable_->mean : part->number_)[row]);
    if (std::ranges::all_of(means, [](double mean) { return std::isfinite(mean); }))
      seeds.push_back(means, 1.0);
  }
  if (seeds.size() < statistics::fewest_replicas) return unknown;
  statistics::Function const of_means = [this](std::span<double const> means) {
    return of_parts(means);
  };
  return statistics::student_factor(seeds.size() - 1) *
         statistics::Jackknife(seeds, 0, of_means).error(1);
}

std::vector<std::string> Quantity::observables() const {
  std::vector<Quantity const*> parts;
  add_parts(parts);
  std::vector<std::string> names;
  for (auto const* part : parts)
    if (part->observable_) names.push_back(part->name_);
  return names;
}

double Quantity::of_observables(std::size_t row, std::span<double const> means) const {
  std::vector<Quantity const*> parts;
  add_parts(parts);
  std::vector<double> all;
  for (auto const* part : parts)
    if (part->observable_) {
      all.push_back(means.front());
      means = means.subspan(1);
    } else {
      all.push_back(part->number_[row]);
    }
  std::span<double const> rest(all);
  return of_parts(rest);
}

std::vector<double> Quantity::errors_of_runs() const {
  if (auto const kept = table_->observables.find(name_); kept != table_->observables.end())
    return kept->second.error;
  auto const [known, is_new] = table_->ratio_errors->try_emplace(name_);
  auto const names = observables();
  for (std::size_t row = 0; is_new && row < table_->runs.size(); ++row)
    known->second.push_back(
        error_of_run(table_->runs[row] / "result.h5", names,
                     [&](std::span<double const> means) { return of_observables(row, means); }));
  known->second.resize(table_->points, unknown);
  return known->second;
}

Quantity::OwnErrors const* Quantity::own_errors() const {
  if (std::exchange(own_errors_sought_, true)) return own_errors_ ? &*own_errors_ : nullptr;
  auto const names = observables();
  if (names.size() < 2) return nullptr;
  Measured found{{}, errors_of_runs()};
  if (std::ranges::none_of(found.error, [](double error) { return std::isfinite(error); }))
    return nullptr;
  for (std::size_t row = 0; row < table_->points; ++row) {
    std::vector<double> means;
    for (auto const& name : names) means.push_back(observable(*table_, name).mean[row]);
    found.mean.push_back(of_observables(row, means));
  }
  auto const pool = seed_errors(*table_, found);
  own_errors_ = {std::move(found), pool};
  return &*own_errors_;
}

double Quantity::widened() const {
  if (own_errors_) return own_errors_->pool.factor;
  return first_ ? std::max(first_->widened(), second_->widened()) : errors_.factor;
}

Quantity::Bias Quantity::bias(std::span<std::size_t const> rows) const {
  if (first_) {
    auto const a = first_->bias(rows), b = second_->bias(rows);
    if (!divides_)
      return {a.mean * b.mean, a.bias * b.mean + a.mean * b.bias,
              std::hypot(a.error * b.mean, a.mean * b.error)};
    double const mean = a.mean / b.mean;
    return {mean, (a.bias - mean * b.bias) / b.mean,
            std::hypot(a.error, mean * b.error) / std::abs(b.mean)};
  }
  if (!bias_) return {of_merged(rows).mean, 0.0, 0.0};
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (auto const row : rows) {
    double const value = bias_->mean[row], error = bias_->error[row];
    if (!std::isfinite(value) || !std::isfinite(error)) continue;
    sum += value;
    squares += error * error;
    count += 1.0;
  }
  double const mean = of_merged(rows).mean;
  if (count == 0.0) return {mean, 0.0, 0.0};
  return {mean, sum / count, std::sqrt(squares) / count};
}

bool Quantity::has_bias() const {
  return first_ ? first_->has_bias() || second_->has_bias() : bias_ != nullptr;
}

Value Quantity::of(std::span<std::size_t const> all) const {
  auto out = without_bias(all);
  if (!has_bias()) return out;
  auto const method = bias(present(all));
  if (std::abs(method.bias) > 0.0 || method.error > 0.0)
    out.error = std::hypot(out.error, method.bias, method.error);
  return out;
}

Value Quantity::without_bias(std::span<std::size_t const> all) const {
  auto const rows = present(all);
  auto out = of_merged(rows);
  if (!first_ || is_key()) return out;
  if (auto const* own = own_errors()) {
    auto const merged = measured(own->measured, own->pool, rows);
    out.error = merged.error;
    out.pooled = merged.pooled;
  }
  return out;
}

Value Quantity::of_merged(std::span<std::size_t const> rows) const {
  if (first_) {
    auto const first = first_->of_merged(rows), second = second_->of_merged(rows);
    bool const pooled = first.pooled || second.pooled;
    double const mean = divides_ ? first.mean / second.mean : first.mean * second.mean;
    if (!first_->is_key() && !second_->is_key()) {
      double const error = error_of_seeds(rows);
      if (std::isfinite(error)) return {mean, error};
    }
    if (!divides_)
      return {mean, std::hypot(first.error * second.mean, first.mean * second.error), pooled};
    return {mean, std::hypot(first.error / second.mean, mean * second.error / second.mean), pooled};
  }
  if (observable_) return measured(*observable_, errors_, rows);
  return {rows.empty() ? unknown : number_[rows.front()], 0.0};
}

std::vector<std::size_t> Quantity::present(std::span<std::size_t const> rows) const {
  std::vector<Quantity const*> parts;
  add_parts(parts);
  std::vector<std::size_t> found;
  std::ranges::copy_if(rows, std::back_inserter(found), [&](std::size_t row) {
    return std::ranges::all_of(parts, [&](auto const* part) {
      return !part->observable_ || std::isfinite(part->observable_->mean[row]);
    });
  });
  return found;
}

double Quantity::resampled(std::span<std::size_t const> all, Draw const& draw) const {
  if (draw.replica == 0 || is_key()) return of(all).mean;
  auto const rows = present(all);
  if (rows.empty()) return unknown;
  bool const is_own = first_ && rows.size() == 1 && own_errors();
  if (first_ && !is_own) {
    double const first = first_->resampled(rows, draw), second = second_->resampled(rows, draw);
    return divides_ ? first / second : first * second;
  }
  if (rows.size() == 1) {
    auto const measured = without_bias(rows);
    return measured.mean +
           (std::isfinite(measured.error) ? measured.error : 0.0) * random_normal(draw, name_);
  }
  std::vector<std::size_t> drawn;
  for (std::uint32_t k = 0; k + 1 < rows.size(); ++k)
    drawn.push_back(rows[random_index(draw, k, rows.size())]);
  return of(drawn).mean;
}

}  // namespace bagnold::analysis
