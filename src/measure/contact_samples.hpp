// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "src/measure/frame_observer.hpp"
#include "src/simulation/contact_table.hpp"

namespace bagnold {

/// Velocities in collisions, each looked at once, at a random step of it: P2 Fig. 21.
///
/// Of all collisions those of the least ranks are kept (SampleChoice::rank): an even choice that
/// does not depend on their order.
class ContactSamples {
 public:
  static constexpr std::size_t most = 5000;  ///< as in P2 Fig. 21

  ContactSamples(SampleChoice choice, bool rotates) : choice_(choice), rotates_(rotates) {}

  void add(OpenContact const& contact);

  void save(Numbers& numbers) const;
  void load(Numbers const& numbers);

  /// Adds those of another system.
  void add(ContactSamples const& other);

  /// `contact_velocities`: V_T, V_R, V_C_T, V_N of each, where disks do not rotate V_T and V_N;
  /// `_mean`, `_covariance` of the columns, and `_axes` of each two of them: nothing of fewer than
  /// two collisions.
  std::vector<statistics::Samples> samples() const;

 private:
  void keep(double rank, ContactVelocities const& velocities);

  SampleChoice choice_;
  bool rotates_;
  std::multimap<double, ContactVelocities> kept_;  ///< by rank
};

}  // namespace bagnold
