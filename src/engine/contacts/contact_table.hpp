// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/cpu/contacts/contact_sample.hpp"

namespace bagnold {

/// A contact that has begun and not ended.
struct OpenContact {
  std::uint32_t a = 0, b = 0;  ///< disks by their index at the start, a < b
  std::int64_t begin = 0;      ///< the first configuration in contact; 0: in contact at the start
  bool binary = true;          ///< neither disk has touched a third one since
  std::int64_t due = SampleChoice::never;  ///< the next sample of its velocities
  ContactVelocities velocities = {};       ///< at the last sample
};

/// All contacts between the disks of one system, which are the edges of the contact graph.
class ContactTable {
 public:
  explicit ContactTable(std::size_t disks) : of_disk_(disks) {}

  bool is_open(std::uint32_t a, std::uint32_t b) const { return find(a, b) != nullptr; }

  /// Contact of two disks; nullptr if there is none. Valid until the table changes.
  OpenContact const* find(std::uint32_t a, std::uint32_t b) const;
  OpenContact* find(std::uint32_t a, std::uint32_t b) {
    return const_cast<OpenContact*>(std::as_const(*this).find(a, b));
  }

  /// Opens and closes a contact. Throws std::logic_error if it exists already, or does not.
  void open(std::uint32_t a, std::uint32_t b, std::int64_t step,
            std::int64_t due = SampleChoice::never);
  OpenContact close(std::uint32_t a, std::uint32_t b);

  /// Number of disks that are connected to a disk by contacts, itself included, counted up to
  /// `most`.
  std::size_t cluster(std::uint32_t disk, std::size_t most) const;

  /// All contacts, sorted by a, then b.
  std::vector<OpenContact> sorted() const;
  void restore(std::vector<OpenContact> const& contacts);

  /// Calls use(contact) in no particular order.
  template <class Use>
  void each(Use const& use) const {
    for (auto const& contact : contacts_)
      if (contact.a != contact.b) use(contact);
  }

 private:
  struct Partner {
    std::uint32_t disk;
    std::uint32_t contact;  ///< in contacts_
  };
  Partner const* partner(std::uint32_t a, std::uint32_t b) const;
  void forget(std::uint32_t disk, std::uint32_t contact);
  void add(OpenContact const& contact);

  std::vector<std::vector<Partner>> of_disk_;  ///< [N]
  std::vector<OpenContact> contacts_;          ///< a = b in unused places
  std::vector<std::uint32_t> vacant_;
};

}  // namespace bagnold
