// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/counts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bagnold {

Counts::Counts(std::vector<double> edges) : edges_(std::move(edges)), count_(edges_.size() - 1) {}

void Counts::add(double value) {
  if (std::isnan(value)) return;
  ++total_;
  auto const above = std::upper_bound(edges_.begin(), edges_.end(), value);
  if (above == edges_.begin() || above == edges_.end()) return;
  ++count_[static_cast<std::size_t>(above - edges_.begin() - 1)];
}

void Counts::add(Counts const& other) {
  for (std::size_t b = 0; b < count_.size(); ++b) count_[b] += other.count_[b];
  total_ += other.total_;
}

statistics::Histogram Counts::histogram(std::string name, std::string unit,
                                        std::string description) const {
  statistics::Histogram h{std::move(name), std::move(unit), std::move(description), edges_, {}};
  for (std::size_t b = 0; b < count_.size(); ++b)
    h.density.push_back(total_ > 0 ? count_[b] / (total_ * (edges_[b + 1] - edges_[b]))
                                   : std::numeric_limits<double>::quiet_NaN());
  return h;
}

std::vector<double> Counts::numbers() const {
  auto all = count_;
  all.push_back(total_);
  return all;
}

void Counts::restore(std::vector<double> const& numbers) {
  count_.assign(numbers.begin(), numbers.end() - 1);
  total_ = numbers.back();
}

std::vector<double> even_edges(double first, double last, std::size_t n) {
  std::vector<double> edges;
  for (std::size_t k = 0; k <= n; ++k)
    edges.push_back(first + (last - first) * static_cast<double>(k) / static_cast<double>(n));
  return edges;
}

std::vector<double> sinh_edges(double centre, double reach, std::size_t n) {
  std::vector<double> edges;
  for (double const u : even_edges(-reach, reach, 2 * n)) edges.push_back(centre + std::sinh(u));
  return edges;
}

}  // namespace bagnold
