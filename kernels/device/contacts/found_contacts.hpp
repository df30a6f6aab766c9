// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// A pair of disks of which something is to be told in one configuration.
struct FoundContact {
  enum What : std::uint32_t {
    begins = 1,   ///< touches now, and did not in the configuration before
    ends = 2,     ///< the other way round
    sampled = 4,  ///< its velocities are sampled, see SampleChoice
    picked = 8    ///< it is offered to those who pick contacts, see PickChoice
  };

  std::int64_t step = 0;
  std::uint32_t a = 0, b = 0;  ///< disks by their index at the start, a < b
  std::uint32_t what = 0;      ///< the sum of these
  Vec2<Real> separation = {};  ///< r_ab, [d_s]
  Vec2<Real> velocity = {};    ///< v_ab, [d_s/tau_e]
  Real spin = 0;               ///< see contact_velocities()
};

/// Contacts that were found, in no particular order.
template <class Space>
struct FoundContacts {
  Kokkos::View<FoundContact*, Space> found;
  Kokkos::View<std::uint32_t*, Space> count;  ///< [1]; more than there is room for: some are lost

  KOKKOS_FUNCTION void add(FoundContact const& contact) const {
    auto const at = Kokkos::atomic_fetch_add(&count(0), 1u);
    if (at < found.extent(0)) found(at) = contact;
  }

  /// Tells the host that something is lost.
  KOKKOS_FUNCTION void lose() const {
    Kokkos::atomic_fetch_add(&count(0), static_cast<std::uint32_t>(found.extent(0)) + 1);
  }
};

}  // namespace bagnold
