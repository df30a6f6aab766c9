// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/profiles.hpp"

#include <algorithm>
#include <limits>

#include "kernels/physics/species.hpp"
#include "src/measure/band.hpp"
#include "src/measure/disk_stress.hpp"
#include "src/measure/profile_quantities.hpp"
#include "src/statistics/replicas.hpp"

namespace bagnold {

namespace {

using C = SliceColumns;
using Averages = std::span<double const>;
constexpr std::size_t columns = C::count;

/// w = v_x - gammadot y in each slice of one frame; 0 in an empty slice.
std::vector<double> excess(Slices const& slices, std::vector<double> const& sums) {
  std::vector<double> w;
  for (std::size_t b = 0; b < slices.n; ++b) {
    double const mass = sums[b * columns + C::mass];
    w.push_back(mass > 0 ? sums[b * columns + C::flow_x] / mass : 0.0);
  }
  return w;
}

/// Columns of a slice between those of the adjacent slices, in the periodic order.
void take_three(Slices const& slices, std::size_t b, Averages all, std::vector<double>& three) {
  three.clear();
  for (std::size_t const k : {b + slices.n - 1, b, b + 1}) {
    auto const row = all.subspan(k % slices.n * columns, columns);
    three.insert(three.end(), row.begin(), row.end());
  }
}

/// One quantity in all slices, from averages over frames.
std::vector<double> profile(Slices const& slices, ProfileQuantity const& quantity, Averages all) {
  std::vector<double> values, three;
  for (std::size_t b = 0; b < slices.n; ++b) {
    take_three(slices, b, all, three);
    values.push_back(quantity.value(three));
  }
  return values;
}

/// Frames with the columns of three slices, so that a jackknife does not carry all the others
/// along.
statistics::Windows frames_of_three(Slices const& slices, std::size_t b,
                                    statistics::Windows const& frames) {
  statistics::Windows three{3 * columns, {}, {}};
  std::vector<double> row;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    take_three(slices, b, frames.row(f), row);
    three.push_back(row, frames.weight[f]);
  }
  return three;
}

std::vector<statistics::Windows const*> addresses(std::vector<statistics::Windows> const& all) {
  std::vector<statistics::Windows const*> list;
  for (auto const& one : all) list.push_back(&one);
  return list;
}

double or_nan(std::optional<double> const& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Profiles::Profiles(Scene const& scene, Slices const& slices)
    : scene_(scene),
      slices_(slices),
      rate_(scene.shear.strain_rate),
      plain_{slices_.n * columns, {}, {}},
      aligned_(plain_) {}

void Profiles::add(Frame const& frame) {
  rate_ = frame.state.strain_rate.value();
  std::vector<double> mass;
  for (double const d : frame.state.diameter) mass.push_back(disk_mass(scene_.mass_by_area(), d));
  auto const stress = disk_stress(scene_, frame.state);
  auto const sums = slice_sums(slices_, frame.state, mass, stress, 0.0);
  double const band = band_position(excess(slices_, sums), slices_.height);
  plain_.push_back(sums, 1.0);
  aligned_.push_back(slice_sums(slices_, frame.state, mass, stress, band - slices_.height / 2),
                     1.0);
  band_position_.insert(band_position_.end(), {frame.strain, band});
}

void Profiles::save(ObserverState& numbers) {
  numbers["profiles"] = plain_.sums;
  numbers["profiles_aligned"] = aligned_.sums;
  numbers["band_position"] = band_position_;
}

void Profiles::load(ObserverState const& numbers) {
  plain_.sums = numbers.at("profiles");
  aligned_.sums = numbers.at("profiles_aligned");
  band_position_ = numbers.at("band_position");
  plain_.weight = aligned_.weight = std::vector<double>(band_position_.size() / 2, 1.0);
}

void Profiles::forget_before(double strain) {
  std::size_t frames = 0;
  while (2 * frames < band_position_.size() && band_position_[2 * frames] < strain) ++frames;
  auto const drop = [frames](std::vector<double>& values, std::size_t each) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(frames * each));
  };
  drop(band_position_, 2);
  for (auto* table : {&plain_, &aligned_}) {
    drop(table->sums, table->columns);
    drop(table->weight, 1);
  }
}

void Profiles::report_profiles(std::vector<statistics::Windows const*> const& frames,
                               std::string const& suffix, FrameResults& results) const {
  double const rate = rate_;
  auto const first = results.profiles.size();
  auto const quantities = profile_quantities(slices_, rate, scene_.rotates());
  for (auto const& quantity : quantities)
    results.profiles.push_back({std::string(quantity.name) + suffix,
                                std::string(quantity.unit),
                                std::string(quantity.meaning),
                                {},
                                {},
                                {}});
  for (std::size_t b = 0; b < slices_.n; ++b) {
    std::vector<statistics::Windows> three;
    for (auto const* system : frames) three.push_back(frames_of_three(slices_, b, *system));
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      auto const estimate = statistics::estimate(addresses(three), 0, quantities[q].value).all;
      auto& profile = results.profiles[first + q];
      profile.y.push_back(slices_.middle(b));
      profile.value.push_back(or_nan(estimate.mean) +
                              (quantities[q].grows ? rate * slices_.middle(b) : 0.0));
      profile.error.push_back(or_nan(estimate.error));
    }
  }
}

void Profiles::report(std::vector<FrameObserver const*> const& systems,
                      FrameResults& results) const {
  std::vector<statistics::Windows const*> plain, aligned;
  std::vector<double> bands;
  for (auto const* system : systems) {
    auto const& of = dynamic_cast<Profiles const&>(*system);
    plain.push_back(&of.plain_);
    aligned.push_back(&of.aligned_);
    bands.insert(bands.end(), of.band_position_.begin(), of.band_position_.end());
  }
  report_profiles(plain, "", results);
  report_profiles(aligned, "_aligned", results);
  results.samples.push_back({"band_position",
                             "centre of the band that shears fastest, in each frame averaged",
                             {"strain [1]", "y [d_s]"},
                             bands});
}

std::vector<SampledObservable> Profiles::observables() const {
  double const rate = rate_;
  auto const quantities = profile_quantities(slices_, rate, scene_.rotates());
  auto const values = [&](std::string_view name, double sign) {
    auto const quantity = *std::ranges::find(quantities, name, &ProfileQuantity::name);
    return [=, slices = slices_](Averages all) {
      auto of_slices = profile(slices, quantity, all);
      for (double& value : of_slices) value *= sign;
      return of_slices;
    };
  };
  auto const share = [&](std::string_view name, double level, double sign) {
    return
        [=, of = values(name, sign)](Averages all) { return share_below(of(all), sign * level); };
  };
  auto const in_band = [&](std::string_view name, double sign) {
    return [rate = values("gammadot", sign), of = values(name, 1.0)](Averages all) {
      return in_fastest_band(rate(all), of(all));
    };
  };
  std::vector<SampledObservable> all;
  auto const add = [&](std::string_view name, std::string_view unit, std::string_view meaning,
                       auto value) {
    all.push_back({{name, unit, meaning, value}, {&aligned_}});
  };
  add("band_fraction_phi", "1", "f of P2 App. B: share of L_y where phi(y) is below phi",
      share("phi", scene_.disks.packing_fraction, 1.0));
  add("band_fraction_gammadot", "1",
      "f' of P2 App. B: share of L_y where gammadot(y) is above gammadot",
      share("gammadot", rate, -1.0));
  add("band_phi_fast", "1", "phi in that eighth of L_y that shears fastest", in_band("phi", 1.0));
  add("band_gammadot_fast", "1/tau_e", "gammadot in that eighth of L_y that shears fastest",
      in_band("gammadot", 1.0));
  add("band_phi_slow", "1", "phi in that eighth of L_y that shears slowest", in_band("phi", -1.0));
  add("band_gammadot_slow", "1/tau_e", "gammadot in that eighth of L_y that shears slowest",
      in_band("gammadot", -1.0));
  return all;
}

}  // namespace bagnold
