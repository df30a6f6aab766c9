// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "src/config/piece_history.hpp"
#include "src/config/piece_table.hpp"
#include "src/config/ramp.hpp"
#include "src/config/rate_schedule.hpp"

namespace bagnold {

/// Strain rate over the steps of a run: constant, or that of a schedule.
class StrainRates {
 public:
  using Stretch = RateSchedule::Stretch;
  static constexpr std::int64_t never = RateSchedule::never;

  StrainRates(double rate) : rate_(rate) {}
  StrainRates(Ramp const& ramp);
  StrainRates(PieceTable const& pieces) : schedule_(std::make_shared<PieceTable>(pieces)) {}
  StrainRates(std::shared_ptr<PieceHistory const> history)
      : schedule_(history), history_(std::move(history)) {}

  /// Stretch of a step. Nothing changes after the last step of a schedule.
  Stretch at(std::int64_t step) const {
    return schedule_ ? schedule_->at(step) : Stretch{0, never, rate_};
  }

  /// Strain from step 0 to the beginning of a stretch.
  DoubleDouble strain_before(Stretch const& stretch) const {
    return schedule_ ? schedule_->strain_before(stretch) : DoubleDouble{};
  }

  /// Pieces so far, where they are decided on as the run goes; else null.
  std::shared_ptr<PieceHistory const> const& history() const { return history_; }

  /// True if motions are scaled where the rate changes, or it never does.
  bool scales_motions() const { return !schedule_ || schedule_->scales_motions(); }

 private:
  double rate_ = 0;
  std::shared_ptr<RateSchedule const> schedule_;  ///< null: constant
  std::shared_ptr<PieceHistory const> history_;
};

/// Strain rates of a scene whose protocol is not a cascade.
StrainRates strain_rates(Scene const& scene);

/// Pieces of a scene whose protocol goes by them, else nothing. Throws InputError where they cannot
/// be run.
std::optional<PieceTable> pieces_of(Scene const& scene);

/// Strain rate of the first step. Of a ramp from a given state: its lowest.
double first_rate(Scene const& scene);

/// Size of the strain rate: of pieces |strain|, both ways added up, over time.
double typical_rate(Scene const& scene);

}  // namespace bagnold
