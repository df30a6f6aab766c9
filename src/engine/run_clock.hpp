// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/rate_change.hpp"
#include "src/config/strain_rates.hpp"
#include "src/engine/clock.hpp"
#include "src/state/snapshot.hpp"

namespace bagnold {

/// Clock of the present step of a run, and of other steps. It depends on the step alone, or in a
/// controlled run on the pieces so far, which a snapshot holds: so interruptions of a run do not
/// matter.
struct RunClock : Clock {
  StrainRates rates;
  std::int64_t rate_end = StrainRates::never;  ///< step at which the rate changes

  RunClock(StrainRates const& all, double dt, Snapshot const& snapshot)
      : Clock{0,
              dt,
              snapshot.state.box_length,
              snapshot.initial_offset,
              snapshot.initial_time,
              snapshot.state.box_aspect},
        rates(all) {
    if (all.history()) {
      auto const known = snapshot.arrays.find(pieces_name);
      pieces_ = std::make_shared<PieceHistory>(
          known == snapshot.arrays.end() ? *all.history() : PieceHistory(known->second));
      rates = StrainRates(pieces_);
    }
    move_to(snapshot.step);
  }

  /// Clock of another step.
  Clock at(std::int64_t step) const {
    Clock clock = *this;
    auto const stretch = rates.at(step);
    clock.strain_rate = stretch.rate;
    clock.rate_step = stretch.begin;
    clock.strain_before = rates.strain_before(stretch);
    return clock;
  }

  void move_to(std::int64_t step) {
    static_cast<Clock&>(*this) = at(step);
    rate_end = rates.at(step).end;
  }

  /// Moves to the next rate at rate_end. Returns the change of all motions there.
  RateChange change_rate() {
    double const before = strain_rate;
    move_to(rate_end);
    if (rates.scales_motions()) return {strain_rate / before, 0};
    return {1, strain_rate - before};
  }

  /// Begins a piece of a controlled run at a step. Returns the change of all motions there. Pieces
  /// that ended before `needed` are forgotten.
  RateChange begin_piece(std::int64_t step, double rate, std::int64_t needed) {
    double const before = strain_rate;
    pieces_->begin(step, rate, mark(step).strain);
    pieces_->forget_before(needed);
    move_to(step);
    return {1, rate - before};
  }

  /// Scales the box, whose images keep their places in it.
  void scale_box(double factor) {
    box_length *= factor;
    initial_offset *= factor;
  }

  /// What a snapshot at a step knows of time: the start, the lists built so far, the last of them
  /// at list_step, and the pieces from there on.
  Snapshot snapshot(std::int64_t step, std::int64_t list_step, std::int64_t builds) const {
    Snapshot s;
    s.list_step = list_step;
    s.step = step;
    s.initial_offset = initial_offset;
    s.initial_time = initial_time;
    s.list_builds = builds;
    if (pieces_) {
      auto pieces = *pieces_;
      pieces.forget_before(list_step);
      s.arrays[pieces_name] = pieces.numbers();
    }
    return s;
  }

 private:
  static constexpr char pieces_name[] = "pieces";

  std::shared_ptr<PieceHistory> pieces_;  ///< of a controlled run; else null
};

}  // namespace bagnold
