// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Results of an observer on each frame separately, where the strain rate changes from frame to
/// frame: histograms and profiles with a leading axis for frames, and the table `ramp_frames` of
/// the frames. Samples of the observer are left out. Data gathered between frames, such as contacts
/// that end, belong to the time since the previous frame.
class EachFrame final : public FrameObserver {
 public:
  /// name: of the observer in saved numbers. plan: of a ramp.
  EachFrame(std::string name, std::unique_ptr<FrameObserver> observer, Plan const& plan)
      : name_(std::move(name)), observer_(std::move(observer)), plan_(plan) {}

  void add(Frame const& frame) override;
  void save(ObserverState& numbers) override;
  void load(ObserverState const& numbers) override;
  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override;

 private:
  using Rows = std::map<std::string, std::vector<double>>;  ///< [frames][n], by the table's name

  std::size_t frames() const;
  FrameResults found_now() const;

  std::string name_;
  std::unique_ptr<FrameObserver> observer_;
  Plan plan_;
  std::vector<double> frames_;  ///< [frames][3]: columns of `ramp_frames`
  Rows histograms_, profiles_;
};

}  // namespace bagnold
