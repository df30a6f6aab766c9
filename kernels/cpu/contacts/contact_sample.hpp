// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/physics/sample_choice.hpp"
#include "kernels/physics/sums/contact_motion.hpp"

namespace bagnold {

/// Sample of a contact in one configuration.
struct ContactSample {
  std::int64_t step = 0;
  std::uint32_t a = 0, b = 0;  ///< disks by their index at the start, a < b
  ContactVelocities velocities;
};

/// Contact in one evaluated configuration, with its rank among all of them.
struct ContactPick {
  Real rank = 0;
  ContactVelocities velocities;
};

/// Collects picked contacts of evaluated configurations.
struct ContactPicker : PickChoice {
  /// Adds the contact if it is picked; `velocities` is called only then. Disks in any order.
  template <class Velocities>
  void operator()(std::vector<ContactPick>& picks_of, std::int64_t step, std::uint32_t a,
                  std::uint32_t b, Velocities const& velocities) const {
    if (picks(a, b, step)) picks_of.push_back({choice.rank_at(a, b, step), velocities()});
  }
};

}  // namespace bagnold
