// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <list>
#include <string_view>

#include "kernels/physics/type_list.hpp"

namespace bagnold {

/// Entries with a `name`, one for each type of a list, then those that a user's program adds. The
/// address of an entry stays valid when another is added.
template <class Entry>
class NamedEntries {
 public:
  /// Calls make.operator()<T>() for each type of a list.
  template <class List, class Make>
  static NamedEntries& of(Make const& make) {
    static NamedEntries entries = [&] {
      NamedEntries made;
      for_each_type<List>([&]<class T>(std::type_identity<T>) {
        made.entries_.push_back(make.template operator()<T>());
      });
      return made;
    }();
    return entries;
  }

  /// Entry of a name; nullptr if there is none.
  Entry const* find(std::string_view name) const {
    auto const found = std::ranges::find(entries_, name, &Entry::name);
    return found == entries_.end() ? nullptr : &*found;
  }

  void add(Entry const& entry) { entries_.push_back(entry); }

  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }

 private:
  std::list<Entry> entries_;
};

}  // namespace bagnold
