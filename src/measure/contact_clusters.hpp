// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "src/measure/counts.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Velocities in contact by the size of the connected cluster that a contact belongs to: in its
/// last configuration, each contact once; and at a random step of it, weighted by its duration,
/// which is a mean over contacts in time.
class ContactClusters {
 public:
  /// Least numbers of disks of the classes of clusters.
  static constexpr std::array<std::size_t, 8> least{2, 3, 4, 6, 9, 17, 33, 64};

  ContactClusters();

  /// Counts a contact that ended, with its velocities and its cluster at a random step. duration:
  /// [steps]; cluster: disks in its last configuration.
  void ends(OpenContact const& contact, std::int64_t duration, std::size_t cluster);

  void save(ObserverState& numbers) const;
  void load(ObserverState const& numbers);
  void add(ContactClusters const& other);

  /// Disks in the clusters in which contacts end.
  statistics::Histogram at_end() const;

  /// `collision_clusters` and `contact_clusters`, a row a class.
  std::vector<statistics::Samples> tables(bool rotates) const;

 private:
  /// Contacts, their weight, and weighted squares of V_N, V_T, V_R, V_C_T over gammadot d_s.
  using Sums = std::array<double, 6>;
  using ByClass = std::array<Sums, least.size()>;

  static void count(ByClass& to, std::size_t cluster, double weight, ContactVelocities const& v);
  static statistics::Samples table(std::string name, std::string description, ByClass const& sums,
                                   bool rotates);

  Counts at_end_;
  ByClass once_{}, in_time_{};
};

}  // namespace bagnold
