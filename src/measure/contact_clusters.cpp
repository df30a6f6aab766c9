// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contact_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "src/measure/contact_histograms.hpp"

namespace bagnold {

ContactClusters::ContactClusters() : at_end_(cluster_edges()) {}

void ContactClusters::ends(OpenContact const& contact, std::int64_t duration, std::size_t cluster) {
  at_end_.add(static_cast<double>(cluster));
  count(once_, cluster, 1, contact.velocities);
  count(in_time_, contact.cluster, static_cast<double>(duration), contact.velocities);
}

void ContactClusters::count(ByClass& to, std::size_t cluster, double weight,
                            ContactVelocities const& v) {
  auto const above = std::ranges::upper_bound(least, cluster);
  if (above == least.begin()) return;
  auto& sums = to[static_cast<std::size_t>(above - least.begin() - 1)];
  auto const square = [&](Real value) { return weight * value * value; };
  Sums const more{1,
                  weight,
                  square(v.normal),
                  square(v.tangential),
                  square(v.rotational),
                  square(v.at_contact())};
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += more[k];
}

void ContactClusters::save(ObserverState& numbers) const {
  numbers["contacts_cluster_end"] = at_end_.numbers();
  auto& all = numbers["contacts_clusters"];
  for (auto const* by_class : {&once_, &in_time_})
    for (auto const& sums : *by_class) all.insert(all.end(), sums.begin(), sums.end());
}

void ContactClusters::load(ObserverState const& numbers) {
  at_end_.restore(numbers.at("contacts_cluster_end"));
  auto from = numbers.at("contacts_clusters").begin();
  for (auto* by_class : {&once_, &in_time_})
    for (auto& sums : *by_class)
      for (auto& value : sums) value = *from++;
}

void ContactClusters::add(ContactClusters const& other) {
  at_end_.add(other.at_end_);
  for (std::size_t c = 0; c < least.size(); ++c)
    for (std::size_t k = 0; k < std::tuple_size_v<Sums>; ++k) {
      once_[c][k] += other.once_[c][k];
      in_time_[c][k] += other.in_time_[c][k];
    }
}

statistics::Histogram ContactClusters::at_end() const {
  return at_end_.histogram("cluster_disks_end", "1",
                           "disks in the connected cluster in the last configuration of a contact; "
                           "the last bin: that many or more");
}

std::vector<statistics::Samples> ContactClusters::tables(bool rotates) const {
  return {table("collision_clusters",
                "root mean squares of relative velocities over gammadot d_s, each of one collision "
                "at a random step of it, by the cluster of its last configuration",
                once_, rotates),
          table("contact_clusters",
                "likewise, weighted by durations: of contacts in time, by the cluster of that step",
                in_time_, rotates)};
}

statistics::Samples ContactClusters::table(std::string name, std::string description,
                                           ByClass const& sums, bool rotates) {
  std::vector<std::string> columns{"least_disks [1]", "contacts [1]", "share [1]", "V_N_rms [1]",
                                   "V_T_rms [1]"};
  if (rotates) columns.insert(columns.end(), {"V_R_rms [1]", "V_C_T_rms [1]"});
  double whole = 0;
  for (auto const& one : sums) whole += one[1];
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> rows;
  for (std::size_t c = 0; c < least.size(); ++c) {
    auto const& of = sums[c];
    rows.insert(rows.end(),
                {static_cast<double>(least[c]), of[0], whole > 0 ? of[1] / whole : none});
    for (std::size_t k = 2; k < (rotates ? of.size() : 4); ++k)
      rows.push_back(of[1] > 0 ? std::sqrt(of[k] / of[1]) : none);
  }
  return {std::move(name), std::move(description), std::move(columns), std::move(rows)};
}

}  // namespace bagnold
