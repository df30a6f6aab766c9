// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

namespace bagnold {

/// A contact that has begun and not ended, of a disk with one of higher index.
struct FollowedContact {
  std::uint32_t b = 0;
  std::int64_t begin = 0;  ///< the first configuration in contact
  std::int64_t due = 0;    ///< the next sample of its velocities
};

/// All of one system, by disks a; disks by their index at the start. No list has a part in it.
template <class Space>
struct OpenContacts {
  static constexpr int room = 16;  ///< contacts of one disk

  using Contact = FollowedContact;
  Kokkos::View<int*, Space> count;         ///< [N]
  Kokkos::View<Contact*, Space> contacts;  ///< [room N]

  /// The contact of two; none: nullptr. Good until a contact of a is opened or closed.
  KOKKOS_FUNCTION Contact* find(std::uint32_t a, std::uint32_t b) const {
    for (int k = 0; k < count(a); ++k)
      if (at(a, k).b == b) return &at(a, k);
    return nullptr;
  }

  /// False where a has no room for it.
  KOKKOS_FUNCTION bool open(std::uint32_t a, Contact const& contact) const {
    if (count(a) == room) return false;
    at(a, count(a)++) = contact;
    return true;
  }

  KOKKOS_FUNCTION void close(std::uint32_t a, Contact* contact) const {
    *contact = at(a, --count(a));
  }

 private:
  KOKKOS_FUNCTION Contact& at(std::uint32_t a, int k) const {
    return contacts(static_cast<std::size_t>(k) * count.extent(0) + a);
  }
};

}  // namespace bagnold
