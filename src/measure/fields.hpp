// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/measure/counts.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Local packing fraction and strain rate of the disks: histograms over all frames, and for a
/// picture the fields of the last frame; of several systems, those of the first.
class Fields final : public FrameObserver {
 public:
  /// The box is least_box_for_fields() wide at least.
  Fields();

  void add(Frame const& frame) override;
  void save(ObserverState& numbers) override;
  void load(ObserverState const& numbers) override;
  void forget_before(double strain) override;
  bool adds_up() const override { return true; }
  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override;

 private:
  Counts packing_fraction_;
  Counts strain_rate_;
  std::vector<double> last_;   ///< [N][5]: x, y, diameter, phi, gammadot
  std::vector<double> frame_;  ///< of the last one: step, strain, box length, offset
};

}  // namespace bagnold
