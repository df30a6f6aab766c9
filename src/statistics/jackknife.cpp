// SPDX-License-Identifier: BSD-3-Clause
#include "src/statistics/jackknife.hpp"

#include <cmath>

namespace bagnold::statistics {

Jackknife::Jackknife(Windows const& windows, std::size_t first, Function const& f)
    : windows_(windows), f_(f), first_(first), total_(windows.columns, 0.0) {
  total_weight_ = add(first_, windows_.size(), total_);
  value_ = without(first_, first_).second;
}

double Jackknife::add(std::size_t begin, std::size_t end, std::vector<double>& sums) const {
  double weight = 0.0;
  for (std::size_t window = begin; window < end; ++window) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k] += windows_.sums[window * windows_.columns + k];
    }
    weight += windows_.weight[window];
  }
  return weight;
}

std::pair<double, double> Jackknife::without(std::size_t begin, std::size_t end) {
  averages_.assign(windows_.columns, 0.0);
  double const weight = add(begin, end, averages_);
  for (std::size_t k = 0; k < total_.size(); ++k) {
    averages_[k] = (total_[k] - averages_[k]) / (total_weight_ - weight);
  }
  return {weight, f_(averages_)};
}

std::vector<double> Jackknife::deviations() {
  std::vector<double> series;
  series.reserve(windows_.size() - first_);
  double const scale = static_cast<double>(windows_.size() - first_) / total_weight_;
  for (std::size_t window = first_; window < windows_.size(); ++window) {
    auto const [weight, f_without] = without(window, window + 1);
    series.push_back(scale * (total_weight_ - weight) * (value_ - f_without));
  }
  return series;
}

double Jackknife::error(std::size_t length) {
  std::size_t const blocks = (windows_.size() - first_) / length;
  std::vector<std::pair<double, double>> values;  // h_b, p_b
  double mean = 0.0;
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t const begin = first_ + b * length;
    std::size_t const end = b + 1 == blocks ? windows_.size() : begin + length;
    auto const [weight, f_without] = without(begin, end);
    double const h = total_weight_ / weight;
    values.emplace_back(h, h * value_ - (h - 1.0) * f_without);
    mean += values.back().second / h;
  }
  double squares = 0.0;
  for (auto const& [h, value] : values) squares += (value - mean) * (value - mean) / (h - 1.0);
  return std::sqrt(squares / static_cast<double>(blocks));
}

}  // namespace bagnold::statistics
