// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/config/scene.hpp"
#include "src/measure/frame_observer.hpp"
#include "src/measure/slices.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold {

/// Profiles over y of flow, packing and stress, and the shares of the bands (P2 Fig. 28, App. B).
///
/// Bands drift. Every profile is therefore kept twice: in the frame of the box and, as
/// NAME_aligned, with each frame shifted so that the centre of the band that shears fastest is at y
/// = L/2. This shift follows noise too and makes a weak band where there is none: check the
/// unshifted profile first.
class Profiles final : public FrameObserver {
 public:
  Profiles(Scene const& scene, Slices const& slices);

  void add(Frame const& frame) override;
  void save(ObserverState& numbers) override;
  void load(ObserverState const& numbers) override;
  void forget_before(double strain) override;
  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override;
  std::vector<SampledObservable> observables() const override;

 private:
  /// frames: [R]
  void report_profiles(std::vector<statistics::Windows const*> const& frames,
                       std::string const& suffix, FrameResults& results) const;

  Scene scene_;
  Slices slices_;
  double rate_;                ///< of the last frame, [1/tau_e]
  statistics::Windows plain_;  ///< a frame is a window; columns: [slices][SliceColumns]
  statistics::Windows aligned_;
  std::vector<double> band_position_;  ///< [frames][2]: strain, and y of the band, [d_s]
};

}  // namespace bagnold
