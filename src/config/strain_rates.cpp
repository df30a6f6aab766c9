// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/strain_rates.hpp"

#include <algorithm>

#include "src/config/scene.hpp"

namespace bagnold {

StrainRates::Stretch StrainRates::at(std::int64_t step) const {
  if (!ramp_) return {0, never, rate_};
  auto const piece = ramp_->piece(std::min(step, ramp_->steps() - 1));
  return {piece.begin, piece.end == ramp_->steps() ? never : piece.end, piece.rate};
}

DoubleDouble StrainRates::strain_before(Stretch const& stretch) const {
  if (!ramp_) return {};
  long double const strain = ramp_->strain(stretch.begin);
  auto const high = static_cast<double>(strain);
  return {high, static_cast<double>(strain - high)};
}

StrainRates strain_rates(Scene const& scene) {
  if (scene.shear.protocol == "ramp") return make_ramp(scene);
  return scene.shear.strain_rate;
}

}  // namespace bagnold
