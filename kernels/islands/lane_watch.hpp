// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/dynamics/contact_event.hpp"
#include "kernels/simd/pack.hpp"

namespace bagnold {

/// Sees the contacts of eight pairs begin and end, one pair a lane, each at its own time.
struct LaneWatch {
  struct Lane {
    std::uint32_t a = 0, b = 0;  ///< disks by their index at the start
    std::vector<ContactEvent>* events = nullptr;
    ContactMotion* motion = nullptr;  ///< by measurement window
  };
  std::int64_t begin = 0;  ///< of the window, [steps]
  unsigned touched = 0;    ///< lanes in contact
  Lane lane[simd::width];

  /// Configurations of the active lanes; step: of each lane, from `begin`.
  void look(simd::Mask active, simd::Mask touching, simd::Pack step,
            Vec2<simd::Pack> const& separation, Vec2<simd::Pack> const& velocity) {
    auto const changed = (touching.lanes() ^ touched) & active.lanes();
    touched ^= changed;
    for (auto lanes = changed; lanes != 0; lanes &= lanes - 1) {
      int const k = __builtin_ctz(lanes);
      lane[k].events->push_back(contact_event(begin + static_cast<std::int64_t>(step.v[k]),
                                              (touched >> k & 1) != 0, lane[k].a, lane[k].b,
                                              at(separation, k), at(velocity, k)));
    }
  }

  /// One lane's configuration is evaluated.
  void sample(int k, std::size_t bin, Vec2<simd::Pack> const& separation,
              Vec2<simd::Pack> const& velocity) const {
    if (touched >> k & 1) lane[k].motion[bin].add(1, at(separation, k), at(velocity, k));
  }

 private:
  static Vec2<Real> at(Vec2<simd::Pack> const& packs, int k) {
    return {packs.x.v[k], packs.y.v[k]};
  }
};

struct NoLaneWatch {
  void look(simd::Mask, simd::Mask, simd::Pack, Vec2<simd::Pack> const&,
            Vec2<simd::Pack> const&) const {}
  void sample(int, std::size_t, Vec2<simd::Pack> const&, Vec2<simd::Pack> const&) const {}
};

}  // namespace bagnold
