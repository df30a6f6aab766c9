// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace bagnold::events {

/// Things that come and go, each at one place as long as it is there.
template <class T>
class Pool {
 public:
  std::uint32_t add() {
    if (vacant_.empty()) {
      vacant_.push_back(static_cast<std::uint32_t>(all_.size()));
      all_.emplace_back();
    }
    auto const place = vacant_.back();
    vacant_.pop_back();
    return place;
  }
  void remove(std::uint32_t place) { vacant_.push_back(place); }
  void clear() {
    vacant_.clear();
    for (auto place = all_.size(); place > 0;)
      vacant_.push_back(static_cast<std::uint32_t>(--place));
  }

  T& operator[](std::uint32_t place) { return all_[place]; }
  T const& operator[](std::uint32_t place) const { return all_[place]; }

 private:
  std::vector<T> all_;
  std::vector<std::uint32_t> vacant_;
};

}  // namespace bagnold::events
