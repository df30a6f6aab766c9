// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "src/analysis/quantity.hpp"
#include "src/config/errors.hpp"

namespace bagnold::analysis {
namespace {

constexpr auto rate_key = "shear.strain_rate";

/// A place on a curve: one datum, or two whose difference is taken.
struct Place {
  Datum first;
  std::optional<Datum> second;
};

struct Measurement {
  Place place;
  double x, x_error, y, error;
  bool pooled;
};

class Builder {
 public:
  Builder(SweepTable const& table, Request const& request, std::string const& x,
          std::string const& y)
      : request_(request),
        x_(std::make_shared<Quantity>(table, x, request.phi_j)),
        y_(std::make_shared<Quantity>(table, y, request.phi_j)) {}

  Series operator()(std::vector<Label> const& labels, std::vector<Place> const& places) const {
    std::vector<Measurement> all;
    for (auto const& place : places) {
      auto const x = x_->of(place.first.rows);
      auto const y = measured_y(place);
      if (request_.range && std::isfinite(x.mean) &&
          (x.mean < request_.range->first || x.mean > request_.range->second))
        continue;
      all.push_back({place, x.mean, x.error, y.mean, y.error, y.pooled});
    }
    auto const wanted = all.size();
    std::erase_if(all, [](auto const& m) { return !std::isfinite(m.x) || !std::isfinite(m.y); });
    auto const has_error = [](auto const& m) { return std::isfinite(m.error) && m.error > 0.0; };
    bool const weighted = std::ranges::any_of(all, has_error);
    if (weighted) std::erase_if(all, [&](auto const& m) { return !has_error(m); });
    std::ranges::stable_sort(all, {}, &Measurement::x);
    auto const kept = all.size();
    if (request_.first != 0) all.resize(std::min(request_.first, kept));
    Series series{labels, {}, {}, wanted - kept};
    series.pooled = static_cast<std::size_t>(std::ranges::count(all, true, &Measurement::pooled));
    series.widened = y_->widened();
    for (auto const& m : all) series.x_error.push_back(m.x_error);
    series.points = [builder = *this, all, weighted](std::uint32_t replica) {
      return builder.points(all, weighted, replica);
    };
    return series;
  }

 private:
  Value measured_y(Place const& place) const {
    auto const first = y_->of(place.first.rows);
    if (!place.second) return first;
    auto const second = y_->of(place.second->rows);
    return {first.mean - second.mean, std::hypot(first.error, second.error),
            first.pooled || second.pooled};
  }

  Points points(std::vector<Measurement> all, bool weighted, std::uint32_t replica) const {
    if (replica != 0) {
      for (auto& m : all) {
        Draw const first{request_.seed, replica, m.place.first.number};
        m.x = x_->resampled(m.place.first.rows, first);
        m.y = y_->resampled(m.place.first.rows, first);
        if (m.place.second)
          m.y -=
              y_->resampled(m.place.second->rows, {request_.seed, replica, m.place.second->number});
      }
      std::ranges::stable_sort(all, {}, &Measurement::x);
    }
    Points out;
    for (auto const& m : all) {
      out.x.push_back(m.x);
      out.y.push_back(m.y);
      if (weighted) out.error.push_back(m.error);
    }
    return out;
  }

  Request request_;
  std::shared_ptr<Quantity const> x_, y_;
};

std::set<double> rates_of(SweepTable const& table, Request const& request) {
  auto const all = table.numbers(rate_key);
  std::set<double> rates;
  for (auto const point : wanted_points(table, request.where)) rates.insert(all[point]);
  return rates;
}

std::pair<double, double> two_of(std::set<double> const& rates, SweepTable const& table,
                                 Request const& request) {
  if (request.rates.size() == 2) {
    auto const [low, high] = std::ranges::minmax(request.rates);
    if (low == high || !rates.contains(low) || !rates.contains(high))
      throw InputError(
          fmt::format("--rates {} {} (must be two of {})", low, high, fmt::join(rates, " ")));
    return {low, high};
  }
  if (!request.rates.empty() || rates.size() < 2)
    throw InputError(fmt::format("--rates needs two strain rates; {} has {}", table.origin,
                                 fmt::join(rates, " ")));
  return {*rates.begin(), *std::next(rates.begin())};
}

}  // namespace

std::string running_key(Request const& request, std::string const& x) {
  if (!request.along.empty()) return request.along;
  return is_key(x) ? x : "disks.packing_fraction";
}

std::vector<Series> make_series(SweepTable const& table, Request const& request,
                                std::string const& x, std::string const& y) {
  Builder const build(table, request, x, y);
  std::vector<Series> out;
  for (auto const& curve :
       curves_of(table, {running_key(request, x), request.by, {}, request.where})) {
    std::vector<Place> places;
    for (auto const& datum : curve.data) places.push_back({datum, {}});
    out.push_back(build(curve.labels, places));
  }
  return out;
}

std::vector<Series> make_differences(SweepTable const& table, Request const& request,
                                     std::string const& x, std::string const& y) {
  Builder const build(table, request, x, y);
  auto const rates = rates_of(table, request);
  auto const [low, high] = two_of(rates, table, request);
  auto const along = table.numbers(x);
  auto const curves_at = [&](double rate) {
    CurveChoice choice{x, request.by, {rate_key}, request.where};
    choice.where[rate_key] = fmt::format("{}", rate);
    return curves_of(table, choice);
  };
  auto const first = curves_at(low), second = curves_at(high);
  // numbers of data count from 0 at each rate: keep the two apart in the bootstrap
  auto const shift = static_cast<std::uint32_t>(table.points);
  std::vector<Series> out;
  for (auto const& curve : first) {
    auto const partner = std::ranges::find(second, curve.labels, &Curve::labels);
    if (partner == second.end()) continue;
    std::vector<Place> places;
    for (auto const& datum : curve.data)
      for (auto other : partner->data) {
        if (datum.rows.empty() || other.rows.empty() ||
            along[datum.rows.front()] != along[other.rows.front()])
          continue;
        other.number += shift;
        places.push_back({datum, other});
      }
    out.push_back(build(curve.labels, places));
  }
  if (out.empty()) throw InputError("no curve is there at both strain rates; give --rates");
  for (auto const& labels : labels_of(table, {x, request.by, {rate_key}, request.where}))
    if (std::ranges::find(out, labels, &Series::labels) == out.end())
      out.push_back(build(labels, {}));
  return out;
}

}  // namespace bagnold::analysis
