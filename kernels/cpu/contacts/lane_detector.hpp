// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/cpu/contacts/contact_event.hpp"
#include "kernels/cpu/contacts/contact_sample.hpp"
#include "kernels/cpu/simd/pack.hpp"

namespace bagnold {

/// Detects beginnings and ends of contacts in a pack of pairs, one pair a lane, each at its own
/// time.
struct LaneDetector {
  struct Lane {
    std::uint32_t a = 0, b = 0;  ///< disks by their index at the start
    std::vector<ContactEvent>* events = nullptr;
    ContactMotion* motion = nullptr;  ///< by measurement window
    std::vector<ContactSample>* samples = nullptr;
    std::vector<ContactPick>* picks = nullptr;
    std::int64_t opened = 0,
                 due = SampleChoice::never;  ///< of the contact, as OpenContact has them
    Real share_a = 0.5, share_b = 0.5;       ///< d / (d_a + d_b)
  };
  SampleChoice choice;
  ContactPicker picker;
  Real strain_rate = 0;    ///< gammadot, [1/tau_e]
  std::int64_t begin = 0;  ///< of the lookahead, [steps]
  unsigned touched = 0;    ///< lanes in contact
  Lane lane[simd::width];

  /// Evaluates the configurations of the active lanes. step: of each lane, counted from `begin`.
  /// spin: of disks a, and of disks b.
  void detect(simd::Mask active, simd::Mask touching, simd::Pack step,
              Vec2<simd::Pack> const& separation, Vec2<simd::Pack> const& velocity,
              Vec2<simd::Pack> const& spin) {
    auto const changed = (touching.lanes() ^ touched) & active.lanes();
    touched ^= changed;
    for (auto lanes = changed; lanes != 0; lanes &= lanes - 1) {
      int const k = __builtin_ctz(lanes);
      lane[k].events->push_back(contact_event(begin + static_cast<std::int64_t>(step.v[k]),
                                              (touched >> k & 1) != 0, lane[k].a, lane[k].b,
                                              at(separation, k), at(velocity, k)));
      if (choice) begin_or_end(lane[k], (touched >> k & 1) != 0);
    }
    if (!choice) return;
    for (auto lanes = touched & active.lanes(); lanes != 0; lanes &= lanes - 1) {
      int const k = __builtin_ctz(lanes);
      auto const now = begin + static_cast<std::int64_t>(step.v[k]);
      if (lane[k].due != now) continue;
      lane[k].samples->push_back({now, lane[k].a, lane[k].b,
                                  contact_velocities(at(separation, k), at(velocity, k),
                                                     common_spin(k, spin), strain_rate)});
      lane[k].due = choice.next(lane[k].a, lane[k].b, lane[k].opened, now);
    }
  }

  /// Evaluates one lane's configuration, `step` steps after `begin`. spin: as in detect().
  void sample(int k, std::size_t bin, std::int64_t step, Vec2<simd::Pack> const& separation,
              Vec2<simd::Pack> const& velocity, Vec2<simd::Pack> const& spin) const {
    if ((touched >> k & 1) == 0) return;
    Lane const& of = lane[k];
    Real const common = common_spin(k, spin);
    of.motion[bin].add(1, at(separation, k), at(velocity, k), common);
    picker(*of.picks, begin + step, of.a, of.b, [&] {
      return contact_velocities(at(separation, k), at(velocity, k), common, strain_rate);
    });
  }

 private:
  Real common_spin(int k, Vec2<simd::Pack> const& spin) const {
    return lane[k].share_a * spin.x.v[k] + lane[k].share_b * spin.y.v[k];
  }

  void begin_or_end(Lane& of, bool begins) const {
    auto const step = of.events->back().step;
    of.opened = step;
    of.due = begins && step != 0 ? choice.first(step) : SampleChoice::never;
  }

  static Vec2<Real> at(Vec2<simd::Pack> const& packs, int k) {
    return {packs.x.v[k], packs.y.v[k]};
  }
};

struct NoLaneDetector {
  void detect(simd::Mask, simd::Mask, simd::Pack, Vec2<simd::Pack> const&, Vec2<simd::Pack> const&,
              Vec2<simd::Pack> const&) const {}
  void sample(int, std::size_t, std::int64_t, Vec2<simd::Pack> const&, Vec2<simd::Pack> const&,
              Vec2<simd::Pack> const&) const {}
};

}  // namespace bagnold
