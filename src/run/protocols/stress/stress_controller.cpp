// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/stress/stress_controller.hpp"

#include "src/config/control.hpp"

namespace bagnold {

StressController::StressController(Scene const& scene, Plan const& plan, double box_length)
    : Controller(scene, plan, box_length), sigma_(quantity("sigma")), inertia_(box_inertia(scene)) {
  auto const steps = static_cast<double>(plan.control_steps);
  auto const last_sample = (plan.control_steps - 1) / plan.every * plan.every;
  ahead_ = 1 - static_cast<double>(last_sample) / 2 / steps;
}

Controller::Piece StressController::next(Ended const& piece) {
  double const sigma = sigma_(piece.averages);
  double const at_end = known_ != 0 ? sigma + ahead_ * (sigma - before_) : sigma;
  before_ = sigma;
  known_ = 1;
  auto const stage = std::min(piece.step * plan().stages / plan().steps, plan().stages - 1);
  double const wanted = scene().shear.stress.at(static_cast<std::size_t>(stage));
  return {piece.rate + (wanted - at_end) * piece_time() / inertia_};
}

}  // namespace bagnold
