// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "src/config/scene.hpp"
#include "src/engine/events/event_choice.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// engine = "adaptive": contacts as events where most disks fly, steps of all disks where they
/// touch, by EventChoice.
///
/// Engines change at ends of measurement windows alone, and events go on by whole windows. Both
/// have one step, the unit of time of events; sums of events are weighed as the configurations that
/// steps would have evaluated. What is handed over is the state.
class AdaptiveEngine final : public Simulation {
 public:
  /// What makes an engine of a scene go on from a snapshot.
  using Make = std::function<std::unique_ptr<Simulation>(Scene const&, Snapshot&&)>;

  AdaptiveEngine(Scene const& scene, Snapshot&& snapshot, Make make);

  int columns() const override { return engine_->columns(); }
  std::int64_t step() const override { return engine_->step(); }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  Snapshot snapshot() const override;
  void give_back_scratch() override { engine_->give_back_scratch(); }
  State state() const override { return engine_->state(); }

 private:
  using Counters = std::map<std::string, double>;

  void go_by_events(Sampling const& sampling, OpenWindows& windows);
  void go_by_steps(std::int64_t end, Sampling const& sampling, OpenWindows& windows);
  void change();
  Counters counters(Counters const& of_engine) const;

  template <class Visit>
  void for_each_memory(Visit const& visit);

  Scene of_events_, of_steps_;
  Make make_;
  std::unique_ptr<Simulation> engine_;
  double disks_, time_step_;
  Counters counters_;       ///< of engines before
  bool by_events_ = false;  ///< which engine that is
  events::EventChoice choice_;
  double contacts_ = 0, weight_ = 0;  ///< of the window under way: `contacts` of its sums
  std::int64_t event_steps_ = 0;      ///< that events took, for reports
};

}  // namespace bagnold
