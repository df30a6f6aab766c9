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
  std::uint32_t cluster = 0;  ///< disks of its cluster at that sample, where these are asked for
};

/// All contacts between the disks of one system, which are the edges of the contact graph. Each
/// contact is a link in two chains, those of its disks.
class ContactTable {
 public:
  explicit ContactTable(std::size_t disks) : first_(disks, none) {}

  bool is_open(std::uint32_t a, std::uint32_t b) const { return find(a, b) != nullptr; }

  /// Contact of two disks; nullptr if there is none. Valid until the table changes.
  OpenContact const* find(std::uint32_t a, std::uint32_t b) const {
    for (auto place = first_[a]; place != none; place = links_[place].next_of(a))
      if (links_[place].other(a) == b) return &links_[place].contact;
    return nullptr;
  }
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
    for (auto const& link : links_)
      if (link.contact.a != link.contact.b) use(link.contact);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;  ///< no place in links_

  struct Link {
    OpenContact contact;                           ///< a = b in unused places
    std::uint32_t after_a = none, after_b = none;  ///< the next links of both disks

    std::uint32_t other(std::uint32_t disk) const {
      return contact.a == disk ? contact.b : contact.a;
    }
    std::uint32_t next_of(std::uint32_t disk) const {
      return contact.a == disk ? after_a : after_b;
    }
    std::uint32_t& next_of(std::uint32_t disk) { return contact.a == disk ? after_a : after_b; }
  };

  void add(OpenContact const& contact);
  void unlink(std::uint32_t disk, std::uint32_t place);

  std::vector<std::uint32_t> first_;  ///< [N], in links_
  std::vector<Link> links_;
  std::vector<std::uint32_t> vacant_;
};

}  // namespace bagnold
