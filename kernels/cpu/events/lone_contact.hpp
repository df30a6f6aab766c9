// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kernels/cpu/events/tournament.hpp"
#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/closed_form/closed_contact.hpp"

namespace bagnold::events {

/// Two disks that touch each other and no third one.
template <bool Rotates>
struct LoneContact {
  std::uint32_t i = 0;          ///< the lower one when it began: places in memory change
  Neighbor other{};             ///< the image of j that it touches
  bool fresh = true;            ///< the closed form begins where the contact does
  bool binary = true;           ///< neither disk has touched a third one
  Real begun = 0;               ///< of the closed form, [tau_e]
  Real touched = 0;             ///< of the contact; -infinity: it was there at the start
  PairMotion<Rotates> start{};  ///< at `begun`
  PairCentre centre{};          ///< at `begun`
  ClosedContact<Rotates> closed{};
  std::uint64_t number = 0;  ///< of its end, where it is reported

  std::uint32_t j() const { return other.index(); }
  Real end() const { return begun + closed.duration; }

  void solve(ContactClass<Rotates> const& c) {
    closed =
        fresh ? ClosedContact<Rotates>::begin(c, start) : ClosedContact<Rotates>::resume(c, start);
  }

  PairCentre centre_at(Real time) const {
    return {centre.position + (time - begun) * centre.velocity, centre.velocity};
  }
};

}  // namespace bagnold::events
