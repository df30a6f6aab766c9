// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/cpu/events/lone_contact.hpp"

namespace bagnold::events {

/// Contacts of two disks alone, each kept for a time after its end. A place is used again soon, so
/// that all of them stay in the processor's cache.
template <bool Rotates>
class ContactRing {
 public:
  /// A contact that begins at a time, and its number. Those that ended longer than `keep` before
  /// are forgotten.
  std::uint32_t add(Real time, Real keep) {
    while (first_ != next_ && (*this)[first_].end() + keep < time) ++first_;
    if (next_ - first_ == all_.size()) grow();
    (*this)[next_] = {};
    return next_++;
  }

  /// Times are counted from a time on.
  void shift(Real time) {
    for (auto k = first_; k != next_; ++k) {
      (*this)[k].begun -= time;
      (*this)[k].touched -= time;
    }
  }

  LoneContact<Rotates>& operator[](std::uint32_t number) { return all_[number & mask()]; }
  LoneContact<Rotates> const& operator[](std::uint32_t number) const {
    return all_[number & mask()];
  }

 private:
  std::uint32_t mask() const { return static_cast<std::uint32_t>(all_.size()) - 1; }

  void grow() {
    std::vector<LoneContact<Rotates>> more(2 * all_.size());
    auto const more_mask = static_cast<std::uint32_t>(more.size()) - 1;
    for (auto k = first_; k != next_; ++k) more[k & more_mask] = (*this)[k];
    all_ = std::move(more);
  }

  std::vector<LoneContact<Rotates>> all_ = std::vector<LoneContact<Rotates>>(16);
  std::uint32_t first_ = 0, next_ = 0;  ///< numbers, which count on and wrap
};

}  // namespace bagnold::events
