// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/strain_rates.hpp"

#include <algorithm>

#include "src/config/oscillation.hpp"
#include "src/config/scene.hpp"
#include "src/config/sequence.hpp"

namespace bagnold {

namespace {

/// A ramp's pieces, each at one rate.
class RampSchedule final : public RateSchedule {
 public:
  explicit RampSchedule(Ramp const& ramp) : ramp_(ramp) {}

  Stretch at(std::int64_t step) const override {
    auto const piece = ramp_.piece(std::min(step, ramp_.steps() - 1));
    return {piece.begin, piece.end == ramp_.steps() ? never : piece.end, piece.rate};
  }

  DoubleDouble strain_before(Stretch const& stretch) const override {
    long double const strain = ramp_.strain(stretch.begin);
    auto const high = static_cast<double>(strain);
    return {high, static_cast<double>(strain - high)};
  }

  bool scales_motions() const override { return true; }

 private:
  Ramp ramp_;
};

}  // namespace

StrainRates::StrainRates(Ramp const& ramp) : schedule_(std::make_shared<RampSchedule>(ramp)) {}

std::optional<PieceTable> pieces_of(Scene const& scene) {
  if (scene.shear.lists_pieces()) return make_sequence(scene);
  if (scene.shear.oscillates()) return make_oscillation(scene);
  return std::nullopt;
}

StrainRates strain_rates(Scene const& scene) {
  if (scene.shear.ramps()) return make_ramp(scene);
  if (auto const pieces = pieces_of(scene)) return *pieces;
  if (scene.shear.controlled())
    return {std::make_shared<PieceHistory const>(scene.shear.strain_rate)};
  return scene.shear.strain_rate;
}

double first_rate(Scene const& scene) {
  auto const pieces = pieces_of(scene);
  return pieces ? pieces->at(0).rate : scene.shear.strain_rate;
}

double typical_rate(Scene const& scene) {
  auto const pieces = pieces_of(scene);
  return pieces ? pieces->typical_rate() : scene.shear.strain_rate;
}

}  // namespace bagnold
