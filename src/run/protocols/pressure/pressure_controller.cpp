// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/pressure/pressure_controller.hpp"

#include <algorithm>
#include <cmath>

namespace bagnold {

PressureController::PressureController(Scene const& scene, Plan const& plan, double box_length)
    : Controller(scene, plan, box_length), pressure_(quantity("p")) {}

Controller::Piece PressureController::next(Ended const& piece) {
  auto const& shear = scene().shear;
  double const excess = pressure_(piece.averages) / shear.pressure - 1;
  double const growth = std::clamp(excess / shear.response, -1.0, 1.0);
  double const strain = piece.rate * piece_time();
  return {piece.rate, std::exp(growth * strain / 2)};
}

}  // namespace bagnold
