// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/run/protocols/controller.hpp"

namespace bagnold {

/// Holds a shear stress, by an inertia M of the box:
///
///     M dgammadot/dt = stress - sigma.
///
/// sigma is taken where a piece ends, from the means of this piece and the one before: a mean over
/// the piece alone would lag behind, and feed oscillations of the box against a packing.
class StressController final : public Controller {
 public:
  StressController(Scene const& scene, Plan const& plan, double box_length);

 private:
  Piece next(Ended const& piece) override;
  std::vector<double*> numbers() override { return {&before_, &known_}; }

  std::function<double(Averages)> sigma_;
  double inertia_;     ///< M, [m]
  double ahead_;       ///< from the mean time of a piece's samples to its end, over a piece
  double before_ = 0;  ///< sigma of the piece before, [m/tau_e^2]
  double known_ = 0;   ///< 1 once there was one
};

}  // namespace bagnold
