// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/measure/counts.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Histogram of thetadot/gammadot over disks and frames (P2 Eqs. 28-29 are its mean and variance,
/// which the observables spin_mean and spin_var hold). Its bins are fine about -1/2, the mean.
class Rotation final : public FrameObserver {
 public:
  void add(Frame const& frame) override;
  void save(ObserverState& numbers) override;
  void load(ObserverState const& numbers) override;
  void forget_before(double strain) override;
  bool adds_up() const override { return true; }
  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override;

 private:
  Counts counts_{sinh_edges(-0.5, 12.0, 240)};  // 0.05 wide at the centre, out to 8e4
};

}  // namespace bagnold
