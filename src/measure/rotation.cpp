// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/rotation.hpp"

namespace bagnold {

void Rotation::add(Frame const& frame) {
  double const rate = frame.state.strain_rate.value();
  for (double const spin : frame.state.spin) counts_.add(spin / rate);
}

void Rotation::save(ObserverState& numbers) { numbers["rotation"] = counts_.numbers(); }

void Rotation::load(ObserverState const& numbers) { counts_.restore(numbers.at("rotation")); }

void Rotation::forget_before(double /*strain*/) { counts_ = Rotation().counts_; }

void Rotation::report(std::vector<FrameObserver const*> const& systems,
                      FrameResults& results) const {
  auto all = Rotation().counts_;
  for (auto const* system : systems) all.add(dynamic_cast<Rotation const&>(*system).counts_);
  results.histograms.push_back(
      all.histogram("rotation", "1", "thetadot/gammadot over disks and frames"));
}

}  // namespace bagnold
