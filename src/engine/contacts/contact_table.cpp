// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/contacts/contact_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace bagnold {

void ContactTable::open(std::uint32_t a, std::uint32_t b, std::int64_t step, std::int64_t due) {
  if (is_open(a, b)) throw std::logic_error("a contact began twice");
  bool const alone = first_[a] == none && first_[b] == none;
  for (auto const disk : {a, b})
    for (auto place = first_[disk]; place != none; place = links_[place].next_of(disk))
      links_[place].contact.binary = false;
  add({std::min(a, b), std::max(a, b), step, alone, due});
}

void ContactTable::add(OpenContact const& contact) {
  if (vacant_.empty()) {
    vacant_.push_back(static_cast<std::uint32_t>(links_.size()));
    links_.emplace_back();
  }
  auto const place = vacant_.back();
  vacant_.pop_back();
  links_[place] = {contact, first_[contact.a], first_[contact.b]};
  first_[contact.a] = first_[contact.b] = place;
}

OpenContact ContactTable::close(std::uint32_t a, std::uint32_t b) {
  auto place = first_[a];
  while (place != none && links_[place].other(a) != b) place = links_[place].next_of(a);
  if (place == none) throw std::logic_error("a contact ended that had not begun");
  OpenContact const contact = links_[place].contact;
  unlink(a, place);
  unlink(b, place);
  links_[place] = {};
  vacant_.push_back(place);
  return contact;
}

void ContactTable::unlink(std::uint32_t disk, std::uint32_t place) {
  auto* link = &first_[disk];
  while (*link != place) link = &links_[*link].next_of(disk);
  *link = links_[place].next_of(disk);
}

std::size_t ContactTable::cluster(std::uint32_t disk, std::size_t most) const {
  std::vector<std::uint32_t> found{disk};
  for (std::size_t k = 0; k < found.size(); ++k)
    for (auto place = first_[found[k]]; place != none; place = links_[place].next_of(found[k])) {
      auto const partner = links_[place].other(found[k]);
      if (std::ranges::find(found, partner) != found.end()) continue;
      found.push_back(partner);
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
  std::ranges::fill(first_, none);
  links_.clear();
  vacant_.clear();
  for (auto const& contact : contacts) add(contact);
}

}  // namespace bagnold
