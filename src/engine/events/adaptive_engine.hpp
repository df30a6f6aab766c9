// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "src/engine/engine_memory.hpp"
#include "src/engine/events/event_choice.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// engine = "auto" where it may take events: contacts as events where most disks fly, steps of all
/// disks where they touch, by EventChoice. It begins with steps.
///
/// Steps are those of engine = "steps", to the last bit until events are taken first. Events are
/// summed from one choice or end of a window to the next, and weighed as the configurations that
/// steps would have evaluated there. What one engine hands over to the other is the state.
class AdaptiveEngine final : public Simulation {
 public:
  /// Makes an engine that goes on from a snapshot.
  using Make = std::function<std::unique_ptr<Simulation>(Snapshot&&)>;

  /// Both engines, and what they share.
  struct Engines {
    Make events, steps;
    double time_step;      ///< dt, [tau_e]
    std::int64_t stretch;  ///< between choices, EventChoice::stretch, [steps]
  };

  AdaptiveEngine(Engines engines, Snapshot&& snapshot);

  /// True if such an engine wrote the snapshot; and if events were under way there.
  static bool wrote(Snapshot const& snapshot);
  static bool wrote_by_events(Snapshot const& snapshot);

  int columns() const override { return engine_->columns(); }
  std::int64_t step() const override { return engine_->step(); }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  bool has_step() const override { return !by_events_; }
  Snapshot snapshot() const override;
  void give_back_scratch() override { engine_->give_back_scratch(); }
  State state() const override { return engine_->state(); }

 private:
  void go_by_events(std::int64_t end, Sampling const& sampling, OpenWindows& windows);
  void add_part(std::vector<double>&& sums, Sampling const& sampling, OpenWindows& windows);
  void go_by_steps(std::int64_t end, Sampling const& sampling, OpenWindows& windows);
  std::int64_t next_choice(std::int64_t step) const {
    return (step / engines_.stretch + 1) * engines_.stretch;
  }
  void choose();
  void change();

  template <class Visit>
  void for_each_memory(Visit const& visit);

  std::unique_ptr<Simulation> make(Snapshot&& from) const {
    return (by_events_ ? engines_.events : engines_.steps)(std::move(from));
  }

  Engines engines_;
  std::unique_ptr<Simulation> engine_;
  double disks_;
  Counters counters_;       ///< of engines before
  bool by_events_ = false;  ///< which engine that is
  events::EventChoice choice_;

  double contacts_ = 0, weight_ = 0;  ///< since the last choice: `contacts` of the sums
  std::int64_t chosen_step_ = 0;      ///< of the last choice, if events are under way
  double work_before_ = 0;            ///< of events at that step

  std::int64_t part_from_ = 0;  ///< where the part of a window began that events are in
  double part_weight_ = 0;      ///< its steps so far

  std::int64_t event_steps_ = 0;  ///< that events took, for reports
};

}  // namespace bagnold
