// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/controller.hpp"

#include <algorithm>

#include "src/engine/control_columns.hpp"
#include "src/measure/observables.hpp"
#include "src/run/protocols/pressure/pressure_controller.hpp"
#include "src/run/protocols/stress/stress_controller.hpp"

namespace bagnold {

Controller::Controller(Scene const& scene, Plan const& plan, double box_length)
    : scene_(scene),
      plan_(plan),
      rate_(scene.shear.strain_rate),
      length_(box_length / scene.box_length()) {}

std::function<double(Controller::Averages)> Controller::quantity(std::string_view name) const {
  auto const list = observables(scene_, scene_.box_length());
  return std::ranges::find(list, name, &Observable::name)->value;
}

void Controller::end_piece(Simulation& simulation, WindowSums const& piece,
                           statistics::Windows& windows) {
  auto sums = piece.sums;
  append_control(sums, piece.weight, {rate_, scene_.disks.packing_fraction, length_},
                 scene_.rotates(), scene_.driven());
  if (window_.sums.empty()) window_.sums.resize(sums.size());
  std::vector<double> averages(sums.size());
  for (std::size_t c = 0; c < sums.size(); ++c) {
    window_.sums[c] += sums[c];
    averages[c] = sums[c] / piece.weight;
  }
  window_.weight += piece.weight;
  auto const step = simulation.step();
  if (step % plan_.window_steps == 0) {
    windows.push_back(window_.sums, window_.weight);
    window_ = {};
  }
  auto const begins = next({step, rate_, averages});
  simulation.begin_piece(begins.rate, begins.scale);
  rate_ = begins.rate;
  length_ *= begins.scale;
}

std::vector<double> Controller::memory() const {
  std::vector<double> all{rate_, length_, window_.weight};
  for (auto const* number : const_cast<Controller&>(*this).numbers()) all.push_back(*number);
  all.insert(all.end(), window_.sums.begin(), window_.sums.end());
  return all;
}

void Controller::load(std::vector<double> const& memory) {
  auto from = memory.begin();
  rate_ = *from++;
  length_ = *from++;
  window_.weight = *from++;
  for (auto* number : numbers()) *number = *from++;
  window_.sums.assign(from, memory.end());
}

std::unique_ptr<Controller> make_controller(Scene const& scene, Plan const& plan,
                                            double box_length) {
  if (scene.shear.finds_rate()) return std::make_unique<StressController>(scene, plan, box_length);
  if (scene.shear.changes_box())
    return std::make_unique<PressureController>(scene, plan, box_length);
  return nullptr;
}

}  // namespace bagnold
