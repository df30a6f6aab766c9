// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/engine/device_copy.hpp"
#include "src/engine/law_engines.hpp"

namespace bagnold::detail {

/// LawEngines::contacts of one law.
template <ContactLaw Law>
FrameContacts frame_contacts(EngineInput const& input, State const& state,
                             HostSearch const& search) {
  using Space = Kokkos::Serial;
  return with_repulsion(input.physics.force_exponent, [&]<class Repulsion>(
                                                          Repulsion const& repulsion) {
    auto const law = Law::make(input.physics.damping);
    NeighborRows<Space> const none;
    ContactForces<Law, Repulsion, Space> const forces{
        search.position,
        to_device<Space>("measure::motion", motions<Law::rotates>(state)),
        search.species,
        make_neighbor_rows(Space{}, search, none),
        input.species,
        search.box,
        law,
        repulsion};
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    FrameContacts contacts;
    for (std::uint32_t i = 0; i < state.count(); ++i)
      forces.each_contact(i, [&](Neighbor neighbor, Vec2<Real> const& separation, Real distance2,
                                 Real inverse_distance, Vec2<Real> const& velocity, Real spins) {
        auto const j = neighbor.index();
        if (j < i) return;
        auto const pair =
            pair_force(law, repulsion, separation, distance2, velocity, inverse_distance, spins);
        auto const distance = std::sqrt(distance2);
        contacts.push_back({i,
                            j,
                            1 / inverse_distance - distance,
                            {separation.x / distance, separation.y / distance},
                            {pair.velocity.x, pair.velocity.y},
                            std::hypot(pair.elastic.x, pair.elastic.y),
                            {pair.dissipative.x, pair.dissipative.y},
                            unknown});
      });
    return contacts;
  });
}

}  // namespace bagnold::detail
