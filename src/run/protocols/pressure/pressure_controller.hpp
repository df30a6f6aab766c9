// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/run/protocols/controller.hpp"

namespace bagnold {

/// Holds a pressure at a given strain rate, by the size of the box:
///
///     d ln(L_x L_y)/d gamma = (p/pressure - 1)/gamma_p,
///
/// at most 1 either way. gamma_p is shear.response.
class PressureController final : public Controller {
 public:
  PressureController(Scene const& scene, Plan const& plan, double box_length);

 private:
  Piece next(Ended const& piece) override;

  std::function<double(Averages)> pressure_;
};

}  // namespace bagnold
