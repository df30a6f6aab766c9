// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/engine/events/event_loop.hpp"
#include "src/engine/events/event_part.hpp"

namespace bagnold::events {

/// Disks with a halo that go alone through a window of time, as if nothing were beyond the halo.
///
/// What own disks do is right if it is so of all that they may touch: if each disk of the halo that
/// they could reach has done the same, to the last bit, in the block whose own it is. Then the
/// first event of own disks that were not one of the whole would need another one before it.
template <bool Rotates>
class EventBlock {
 public:
  EventBlock(EventState<Rotates> const& whole, Part part);

  /// Takes what has changed in the whole since it was here: in own disks too, or in the halo alone.
  void begin(bool own_too);

  /// Goes on to a time, or to where lists are to be built.
  void run(Real until) { loop_.run(until); }

  /// Step at which lists are to be built, by own disks.
  std::int64_t build_step() const { return s_.build_step; }
  /// True if the window is known to be wrong.
  bool failed() const { return cut_ || s_.too_deep; }

  /// When the first own disk leaves its reach, as far as is known.
  Real leaves() const;

  /// True if own disks have met nobody who was not as in other blocks. of(i): the block whose own
  /// disk i is; window: its time.
  template <class Of>
  bool agrees(Of const& of, Real window) const {
    auto const owner = [&](std::uint32_t k) -> EventBlock const& { return of(part_.of_whole[k]); };
    for (auto const k : part_.neighbors)
      if (!same_as_in(owner(k), k) && may_be_met(owner(k), k, window)) return false;
    for (std::uint32_t k = own_first(); k < own_end(); ++k) {
      if (s_.disks.path[k].manner != Manner::cluster) continue;
      for (auto const& m : s_.disks.clusters[s_.disks.touching[k]].members)
        if (!s_.disks.owns(m.disk) && !same_as_in(owner(m.disk), m.disk)) return false;
    }
    return true;
  }

  /// Gives the whole the paths of own disks that have changed; then, one block at a time, what
  /// these touch, sums and counts.
  void give_paths(EventState<Rotates>& whole);
  void give_rest(EventState<Rotates>& whole) const;

  int depth() const { return part_.depth; }  ///< of the halo

 private:
  std::uint32_t own_first() const { return part_.own_first; }
  std::uint32_t own_end() const { return part_.own_first + part_.count; }
  bool same_as_in(EventBlock const& owner, std::uint32_t k) const;
  bool may_be_met(EventBlock const& owner, std::uint32_t k, Real window) const;
  void renew();
  void mark(std::uint32_t k);
  void take(std::uint32_t k);

  EventState<Rotates> const& whole_;
  Part part_;
  EventState<Rotates> s_;
  EventLoop<Rotates> loop_;
  bool new_ = true;
  bool cut_ = false;                     ///< an own disk touches one beyond the halo
  std::vector<std::uint8_t> marked_;     ///< of the part: differs from the whole
  std::vector<std::uint32_t> differ_;    ///< those that do
  std::vector<std::uint32_t> changes_;   ///< of own paths at the begin of the window
  std::vector<std::uint32_t> contacts_;  ///< own disks whose changed paths begin with one
  std::vector<std::uint32_t> clusters_;  ///< own disks that are first in one
};

extern template class EventBlock<false>;
extern template class EventBlock<true>;

}  // namespace bagnold::events
