// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/side_by_side.hpp"
#include "kernels/device/team.hpp"

namespace bagnold {

/// Loops over the disks of one system, each a launch from the host. Where a loop is called by host
/// and device alike, its body is the same named functor in both.
template <class Space>
struct Launches {
  Space space;

  template <class Body>
  void for_all(char const* label, std::int64_t count, Body const& body) const {
    side_by_side::parallel_for(label, policy(count), body);
  }
  template <class Body, class Reducer>
  void reduce(char const* label, std::int64_t count, Body const& body,
              Reducer const& reducer) const {
    side_by_side::parallel_reduce(label, policy(count), body, reducer);
  }

 private:
  /// Light-weight: a functor goes to the device with its launch, up to 4 KB. Those beyond 512 bytes
  /// would else go by constant memory, and wait there for the launch before.
  auto policy(std::int64_t count) const {
    using Policy = Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>;
    return Kokkos::Experimental::require(Policy(space, 0, count),
                                         Kokkos::Experimental::WorkItemProperty::HintLightWeight);
  }
};

/// Loops by the threads of one team, from inside a kernel, with a barrier after each.
template <class Team>
struct TeamLoops {
  Team const& team;

  template <class Body>
  KOKKOS_FUNCTION void for_all(char const*, std::int64_t count, Body const& body) const {
    team::for_all(team, static_cast<std::int32_t>(count), body);
  }
  template <class Body, class Reducer>
  KOKKOS_FUNCTION void reduce(char const*, std::int64_t count, Body const& body,
                              Reducer const& reducer) const {
    team::reduce(team, static_cast<std::int32_t>(count), body, reducer);
  }
};

}  // namespace bagnold
