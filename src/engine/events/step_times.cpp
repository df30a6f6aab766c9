// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/step_times.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bagnold::events {

namespace {

constexpr std::int64_t most_steps = StrainRates::never / 4;

}  // namespace

StepTimes::StepTimes(StrainRates const& rates, Real time_step)
    : rates_(rates), time_step_(time_step), unit_rate_(rates.at(0).rate) {
  find_base();
}

void StepTimes::count_from(std::int64_t step) {
  origin_ = step;
  find_base();
}

void StepTimes::move_to(std::int64_t step) {
  at_ = step;
  find_base();
}

void StepTimes::find_base() {
  auto const stretch = rates_.at(at_);
  auto const begin = std::max(stretch.begin, origin_);
  speed_ = stretch.rate / unit_rate_;
  pace_ = speed_ * time_step_;
  first_ = begin - origin_;
  base_ = first_ == 0 ? 0 : between(origin_, begin);
  last_ = stretch.end == StrainRates::never ? StrainRates::never : stretch.end - origin_;
  end_ = last_ == StrainRates::never ? 0 : between(origin_, stretch.end);
}

DoubleDouble StepTimes::strain(std::int64_t step) const {
  auto const stretch = rates_.at(step);
  return rates_.strain_before(stretch) +
         exact_product(stretch.rate, time_step_) * static_cast<double>(step - stretch.begin);
}

Real StepTimes::between(std::int64_t from, std::int64_t to) const {
  auto const stretch = rates_.at(from);
  if (stretch.rate == unit_rate_ && stretch.begin <= to && to <= stretch.end)
    return time_step_ * static_cast<Real>(to - from);
  return (strain(to) + strain(from) * -1.0).rounded() / unit_rate_;
}

std::int64_t StepTimes::step_at(Real from) const {
  auto step = first_ + static_cast<std::int64_t>(std::ceil((from - base_) / pace_));
  if (step > last_) return last_;
  if (time(step) < from) return step + 1;
  return step > first_ && time(step - 1) >= from ? step - 1 : step;
}

std::int64_t StepTimes::last_within(Real strain) const {
  if (last_ == StrainRates::never && first_ == 0) {
    Real const steps = strain / (speed_ * unit_rate_ * time_step_);
    return steps < 1e18 ? std::max<std::int64_t>(1, static_cast<std::int64_t>(steps)) : most_steps;
  }
  Real const longest = strain / unit_rate_;
  auto const within = [&](std::int64_t steps) {
    return between(origin_, origin_ + steps) <= longest;
  };
  std::int64_t low = 1, high = 2;
  while (high < most_steps && within(high)) low = std::exchange(high, 2 * high);
  while (high - low > 1) (within((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

}  // namespace bagnold::events
