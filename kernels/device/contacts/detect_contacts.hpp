// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/contacts/found_contacts.hpp"
#include "kernels/device/contacts/open_contacts.hpp"
#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/physics/sample_choice.hpp"
#include "kernels/physics/sums/contact_motion.hpp"

namespace bagnold {

/// Sees the contacts of a disk with those of higher index begin and end in one configuration, and
/// sums its motion. Forces: ContactForces.
template <class Forces, class Space>
struct DetectContacts {
  Forces forces;
  Kokkos::View<std::uint32_t*, Space> original;  ///< [N], index at the start; empty: as they lie
  OpenContacts<Space> open;
  FoundContacts<Space> found;
  SampleChoice choice;
  PickChoice picks;
  std::int64_t step = 0;
  bool sampled = false;                         ///< the configuration is evaluated
  Kokkos::View<ContactMotion*, Space> of_disk;  ///< [N], by index at the start; where sampled

  KOKKOS_FUNCTION void operator()(std::int64_t i) const {
    auto const a = index(static_cast<std::uint32_t>(i));
    ContactMotion motion;
    auto const wanted = [&](std::uint32_t j, bool touching) {
      auto const b = index(j);
      return b > a && (touching || open.find(a, b) != nullptr);
    };
    forces.each_neighbor(static_cast<std::uint32_t>(i), wanted,
                         [&](Neighbor j, bool touching, Vec2<Real> const& separation,
                             Real inverse_distance, Vec2<Real> const& velocity, Real spins) {
                           Real const spin = spins * inverse_distance / 2;
                           FoundContact pair{step,     a,   index(j.index()), 0, separation,
                                             velocity, spin};
                           pair.what = follow(pair, touching);
                           if (touching && sampled) {
                             motion.add(1, separation, velocity, spin);
                             if (picks.picks(a, pair.b, step)) pair.what |= FoundContact::picked;
                           }
                           if (pair.what != 0) found.add(pair);
                         });
    if (sampled) of_disk(a) = motion;
  }

 private:
  KOKKOS_FUNCTION std::uint32_t index(std::uint32_t i) const {
    return original.extent(0) == 0 ? i : original(i);
  }

  /// Brings `open` up to date, and says what happened.
  KOKKOS_FUNCTION std::uint32_t follow(FoundContact const& pair, bool touching) const {
    auto* contact = open.find(pair.a, pair.b);
    std::uint32_t what = 0;
    if (!touching) {
      open.close(pair.a, contact);
      return FoundContact::ends;
    }
    if (contact == nullptr) {
      // What is in contact at the start has no beginning, so no step of it can be chosen.
      auto const due = step == 0 ? SampleChoice::never : choice.first(step);
      if (!open.open(pair.a, {pair.b, step, due})) found.lose();
      contact = open.find(pair.a, pair.b);
      what = FoundContact::begins;
    }
    if (contact == nullptr || contact->due != step) return what;
    contact->due = choice.next(pair.a, pair.b, contact->begin, step);
    return what | FoundContact::sampled;
  }
};

}  // namespace bagnold
