// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/rotation.hpp"

namespace bagnold {

void Rotation::add(Frame const& frame) {
  double const rate = frame.state.strain_rate.value();
  for (double const spin : frame.state.spin) counts_.add(spin / rate);
}

void Rotation::save(Numbers& numbers) { numbers["rotation"] = counts_.numbers(); }

void Rotation::load(Numbers const& numbers) { counts_.restore(numbers.at("rotation")); }

void Rotation::join(FrameObserver const& other) {
  counts_.add(dynamic_cast<Rotation const&>(other).counts_);
}

void Rotation::report(FrameResults& results) const {
  results.histograms.push_back(
      counts_.histogram("rotation", "1", "thetadot/gammadot over disks and frames"));
}

}  // namespace bagnold
