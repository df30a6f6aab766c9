// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// Work of a lookahead, repetitions included.
struct LookaheadWork {
  Real binary = 0;        ///< islands of two disks
  Real binary_steps = 0;  ///< of a pair
  Real others = 0;        ///< disks in larger islands
  Real batches = 0;       ///< that these were stepped in
  Real touching = 0;      ///< pairs in batches, mean over steps

  /// Cost of the lookahead, [cycles at 2.6 GHz]. It is counted, not timed, so that choices by it
  /// are the same on every machine. Fitted to times of lookaheads of 16 to 256 steps (CD_n 0.78 and
  /// CD_rot 0.76, Q = 1 and 50, rates from 1e-4 to 1e-6, N = 1024 and 65536, both schemes): 0.66 to
  /// 1.3 of these, in four cases of five 0.8 to 1.1.
  Real cost(Real steps, Real disks, Real outer_pairs) const {
    return 3.3 * outer_pairs + 6 * disks + 850 * binary + 57 * binary_steps + 250 * others +
           (17 * others + 305 * batches + 32 * touching) * steps;
  }
};

/// Decision between lookaheads and steps of all disks, by their cost, which depends mostly on Z.
/// Lookaheads are tried once Z, averaged over some thousand steps, is low enough. They are given up
/// when they have cost too much more than ordinary steps.
class LookaheadGain {
 public:
  /// Records ordinary steps.
  void steps_done(Real steps, Real contacts) { remember(steps, contacts); }

  bool enter() const { return contacts_ <= enter_below_; }

  /// Records a lookahead of `steps` steps; costs are those of a disk, [cycles]. Returns whether
  /// lookaheads continue. If they do not, they are tried again once Z has fallen to 0.8 of its
  /// mean. If they did not pay since they began, the threshold falls below its former value too.
  bool lookahead_done(Real steps, Real contacts, Real cost, Real one_by_one) {
    remember(steps, contacts);
    lost_ = std::max<Real>(0, lost_ + cost - one_by_one);
    lost_since_entry_ += cost - one_by_one;
    if (lost_ <= std::max(most_lost, 24 * one_by_one)) return true;  // long ones are tried in fours
    bool const paid = lost_since_entry_ < 0;
    enter_below_ = 0.8 * (paid ? contacts_ : std::min(contacts_, enter_below_));
    lost_ = lost_since_entry_ = 0;
    return false;
  }

  /// Visits the numbers that a bit-for-bit restart needs.
  template <class Visit>
  void for_each_memory(Visit const& visit) {
    visit("enter_lookahead_below", enter_below_);
    visit("usual_contacts", contacts_);
    visit("lost_in_lookahead", lost_);
    visit("lost_since_entry", lost_since_entry_);
  }

 private:
  static constexpr Real memory = 2048;      ///< steps
  static constexpr Real most_lost = 16384;  ///< about a thousand steps of a disk

  void remember(Real steps, Real contacts) {
    Real const share = contacts_ == 0 ? 1 : std::min<Real>(1, steps / memory);
    contacts_ += share * (contacts - contacts_);
  }

  Real enter_below_ = 0.3;  ///< contacts per disk
  Real contacts_ = 0;       ///< Z, running mean; 0: not known yet
  Real lost_ = 0;           ///< what lookaheads cost more, since they last paid, [cycles a disk]
  Real lost_since_entry_ = 0;
};

}  // namespace bagnold
