// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/contacts/contact_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace bagnold {

OpenContact const* ContactTable::find(std::uint32_t a, std::uint32_t b) const {
  auto const* const found = partner(a, b);
  return found == nullptr ? nullptr : &contacts_[found->contact];
}

ContactTable::Partner const* ContactTable::partner(std::uint32_t a, std::uint32_t b) const {
  for (auto const& partner : of_disk_[a])
    if (partner.disk == b) return &partner;
  return nullptr;
}

void ContactTable::open(std::uint32_t a, std::uint32_t b, std::int64_t step, std::int64_t due) {
  if (is_open(a, b)) throw std::logic_error("a contact began twice");
  bool const alone = of_disk_[a].empty() && of_disk_[b].empty();
  add({std::min(a, b), std::max(a, b), step, alone, due});
  if (alone) return;
  for (auto const disk : {a, b})
    for (auto const& partner : of_disk_[disk]) contacts_[partner.contact].binary = false;
}

void ContactTable::add(OpenContact const& contact) {
  if (vacant_.empty()) {
    vacant_.push_back(static_cast<std::uint32_t>(contacts_.size()));
    contacts_.emplace_back();
  }
  auto const place = vacant_.back();
  vacant_.pop_back();
  contacts_[place] = contact;
  of_disk_[contact.a].push_back({contact.b, place});
  of_disk_[contact.b].push_back({contact.a, place});
}

OpenContact ContactTable::close(std::uint32_t a, std::uint32_t b) {
  auto const* const found = partner(a, b);
  if (found == nullptr) throw std::logic_error("a contact ended that had not begun");
  auto const place = found->contact;
  OpenContact const contact = contacts_[place];
  forget(a, place);
  forget(b, place);
  contacts_[place] = {};
  vacant_.push_back(place);
  return contact;
}

void ContactTable::forget(std::uint32_t disk, std::uint32_t contact) {
  std::erase_if(of_disk_[disk], [&](Partner const& p) { return p.contact == contact; });
}

std::size_t ContactTable::cluster(std::uint32_t disk, std::size_t most) const {
  std::vector<std::uint32_t> found{disk};
  for (std::size_t k = 0; k < found.size(); ++k)
    for (auto const& partner : of_disk_[found[k]]) {
      if (std::ranges::find(found, partner.disk) != found.end()) continue;
      found.push_back(partner.disk);
      if (found.size() == most) return most;
    }
  return found.size();
}

std::vector<OpenContact> ContactTable::sorted() const {
  std::vector<OpenContact> all;
  each([&](OpenContact const& contact) { all.push_back(contact); });
  std::ranges::sort(all, {}, [](OpenContact const& c) { return std::tuple(c.a, c.b); });
  return all;
}

void ContactTable::restore(std::vector<OpenContact> const& contacts) {
  for (auto& partners : of_disk_) partners.clear();
  contacts_.clear();
  vacant_.clear();
  for (auto const& contact : contacts) add(contact);
}

}  // namespace bagnold
