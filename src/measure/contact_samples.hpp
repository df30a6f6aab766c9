// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "kernels/cpu/contacts/contact_sample.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// A uniform choice of velocities in contact: of all that are added it keeps those of the smallest
/// ranks, see SampleChoice, so that it does not depend on their order.
class ContactSamples {
 public:
  static constexpr std::size_t most = 5000;  ///< as in P2 Fig. 21

  void add(ContactPick const& pick);

  /// Adds the choice of another system.
  void add(ContactSamples const& other);

  /// Smallest rank that is not kept.
  Real limit() const;

  std::vector<double> numbers() const;
  void restore(std::vector<double> const& numbers);

  std::vector<ContactVelocities> velocities() const;

 private:
  std::multimap<Real, ContactVelocities> kept_;  ///< by rank
};

/// Sums of such velocities over gammadot d_s, each of weight 1.
ContactMotion sums_of(std::vector<ContactVelocities> const& velocities);

/// Tables of a set of velocities in contact.
struct VelocityTables {
  std::string name;         ///< `contact_velocities`
  std::string description;  ///< of the rows
  bool rotates;

  /// NAME: V_T, V_R, V_C_T, V_N of each, where disks do not rotate V_T and V_N; NAME_mean,
  /// NAME_covariance of these columns, and NAME_axes of each two of them, from `sums` over
  /// gammadot d_s. Nothing of fewer than two.
  std::vector<statistics::Samples> operator()(std::vector<ContactVelocities> const& velocities,
                                              ContactMotion const& sums) const;
};

}  // namespace bagnold
