// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernels/physics/random.hpp"
#include "kernels/physics/sums/contact_motion.hpp"

namespace bagnold {

/// A contact is sampled in one configuration.
struct ContactSample {
  std::int64_t step = 0;
  std::uint32_t a = 0, b = 0;  ///< disks by their index at the start, a < b
  ContactVelocities velocities;
};

/// In which of its configurations a contact is sampled: when it ends, the last sample has been at
/// each of them with equal chance.
///
/// A reservoir of one, with jumps (Li, ACM Trans. Math. Softw. 20, 481 (1994)): after the j-th
/// configuration comes the one of number floor(j/u) + 1, u even in (0, 1], so about ln n samples in
/// n configurations. u is a hash of seed, disks and step: no thread, list or restart has a part in
/// it.
class SampleChoice {
 public:
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

  SampleChoice() = default;
  explicit SampleChoice(std::int64_t seed)
      : stream_(Stream::contact_samples, static_cast<std::uint64_t>(seed)), on_(true) {}

  explicit operator bool() const { return on_; }

  /// The first sample of a contact that begins at a step.
  std::int64_t first(std::int64_t begin) const { return on_ ? begin : never; }

  /// The sample after the one at step `now`. Disks in any order.
  std::int64_t next(std::uint32_t a, std::uint32_t b, std::int64_t begin, std::int64_t now) const {
    Real const step = static_cast<Real>(now - begin + 1) / uniform(a, b, now);
    constexpr Real most = 4e18;  // below 2^62
    return begin + static_cast<std::int64_t>(std::fmin(step, most));
  }

  /// A number in (0, 1] of a whole contact, by which some of many may be picked.
  Real rank(std::uint32_t a, std::uint32_t b, std::int64_t begin) const {
    constexpr std::int64_t aside = std::int64_t{1} << 62;  // no step
    return uniform(a, b, begin ^ aside);
  }

  /// Likewise of a contact in the configuration at a step.
  Real rank_at(std::uint32_t a, std::uint32_t b, std::int64_t step) const {
    constexpr std::int64_t aside = std::int64_t{1} << 61;  // no step
    return uniform(a, b, step ^ aside);
  }

 private:
  Real uniform(std::uint32_t a, std::uint32_t b, std::int64_t step) const {
    auto const pair = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    return stream_.uniform(pair, static_cast<std::uint64_t>(step));
  }

  RandomStream stream_{Stream::contact_samples, 0};
  bool on_ = false;
};

/// A contact in one evaluated configuration, and its rank among all of them.
struct ContactPick {
  Real rank = 0;
  ContactVelocities velocities;
};

/// Picks the contacts of evaluated configurations that may be among those of the least ranks, which
/// are an even choice of all: a contact has as many chances as configurations it lasts.
struct ContactPicker {
  SampleChoice choice;
  std::int64_t first_step = 0;  ///< from which on
  Real limit = 0;               ///< of the ranks

  /// Adds the contact, whose velocities are asked for only then. Disks in any order.
  template <class Velocities>
  void operator()(std::vector<ContactPick>& picks, std::int64_t step, std::uint32_t a,
                  std::uint32_t b, Velocities const& velocities) const {
    if (!choice || step < first_step) return;
    Real const rank = choice.rank_at(a, b, step);
    if (rank < limit) picks.push_back({rank, velocities()});
  }
};

}  // namespace bagnold
