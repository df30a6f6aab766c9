// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/physics/random.hpp"

namespace bagnold {

/// Choice of the configuration in which a contact is sampled: when it ends, each of its
/// configurations has been the last sample with equal probability.
///
/// Reservoir sampling of one, with jumps (Li, ACM Trans. Math. Softw. 20, 481 (1994)): after the
/// j-th configuration comes the one of number floor(j/u) + 1, u uniform in (0, 1], so about ln n
/// samples in n configurations. u is a hash of seed, disks and step, so it depends on no thread,
/// list or restart.
class SampleChoice {
 public:
  static constexpr std::int64_t never = INT64_MAX;

  SampleChoice() = default;
  explicit SampleChoice(std::int64_t seed)
      : stream_(Stream::contact_samples, static_cast<std::uint64_t>(seed)), on_(true) {}

  KOKKOS_FUNCTION explicit operator bool() const { return on_; }

  /// First sample of a contact that begins at a step.
  KOKKOS_FUNCTION std::int64_t first(std::int64_t begin) const { return on_ ? begin : never; }

  /// Sample after the one at step `now`. Disks in any order.
  KOKKOS_FUNCTION std::int64_t next(std::uint32_t a, std::uint32_t b, std::int64_t begin,
                                    std::int64_t now) const {
    Real const step = static_cast<Real>(now - begin + 1) / uniform(a, b, now);
    constexpr Real most = 4e18;  // below 2^62
    return begin + static_cast<std::int64_t>(step < most ? step : most);
  }

  /// Random rank of a whole contact in (0, 1], by which some of many are picked.
  KOKKOS_FUNCTION Real rank(std::uint32_t a, std::uint32_t b, std::int64_t begin) const {
    constexpr std::int64_t aside = std::int64_t{1} << 62;  // no step
    return uniform(a, b, begin ^ aside);
  }

  /// Random rank of a contact in the configuration at a step, in (0, 1].
  KOKKOS_FUNCTION Real rank_at(std::uint32_t a, std::uint32_t b, std::int64_t step) const {
    constexpr std::int64_t aside = std::int64_t{1} << 61;  // no step
    return uniform(a, b, step ^ aside);
  }

 private:
  KOKKOS_FUNCTION Real uniform(std::uint32_t a, std::uint32_t b, std::int64_t step) const {
    auto const pair = std::uint64_t{a < b ? a : b} << 32 | (a < b ? b : a);
    return stream_.uniform(pair, static_cast<std::uint64_t>(step));
  }

  RandomStream stream_{Stream::contact_samples, 0};
  bool on_ = false;
};

/// Choice of contacts in evaluated configurations for collectors that keep those of the smallest
/// ranks. These are a uniform choice of all: a contact has a chance in each configuration in which
/// it exists.
struct PickChoice {
  SampleChoice choice;
  std::int64_t first_step = 0;  ///< from which on
  Real limit = 0;               ///< of the ranks

  /// Disks in any order.
  KOKKOS_FUNCTION bool picks(std::uint32_t a, std::uint32_t b, std::int64_t step) const {
    return choice && step >= first_step && choice.rank_at(a, b, step) < limit;
  }
};

}  // namespace bagnold
