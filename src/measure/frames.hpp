// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "src/config/plan.hpp"
#include "src/engine/simulation.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Observers of one simulation, and the configurations that each of them sees.
///
/// An observer sees the first configuration at or after each multiple of its spacing at which the
/// engine can stop; where windows are longer than the spacing, multiples share a frame. The frames
/// do not depend on how the run is cut into calls, if no call goes beyond next().
class Frames {
 public:
  /// plan: of the run, for the strain of a step.
  explicit Frames(Plan const& plan = {}) : plan_(plan) {}

  /// spacing: [steps], 1 at least. Frames before first_step are not shown; without one all are.
  void add_observer(std::unique_ptr<FrameObserver> observer, std::int64_t spacing,
                    std::optional<std::int64_t> first_step = {});

  /// First step after `step` at which an observer is due.
  std::int64_t next(std::int64_t step) const;

  /// Shows the configuration to all observers that became due after step `from`, at which the last
  /// one was shown; -1: before step 0.
  void show(Simulation const& simulation, std::int64_t from);

  /// Calls all observers, see FrameObserver.
  void know_contacts(std::shared_ptr<ContactRecord const> const& record);
  void begin();
  ObserverState save();
  void load(ObserverState const& numbers);

  /// Observers that have a first step forget what they saw before this one, and begin no earlier.
  void forget_before(std::int64_t step);

  /// Shows a configuration again to those that add up frames, if theirs begin with it: after
  /// forget_before() of the step that it has.
  void show_first_again(Simulation const& simulation);
  std::vector<std::string> lost() const;
  void finish();
  void tidy();

  /// Joins the results of the same observers over the frames of several systems, [R], at least one.
  static FrameResults join(std::vector<Frames const*> const& systems);
  static std::vector<SampledObservable> observables(std::vector<Frames const*> const& systems);

 private:
  struct Observed {
    std::unique_ptr<FrameObserver> observer;
    std::int64_t spacing;
    std::optional<std::int64_t> first_step;

    bool waits(std::int64_t from, std::int64_t to) const;
  };
  template <class Wanted>
  void show_to(Simulation const& simulation, Wanted const& wanted);

  Plan plan_;
  static std::vector<FrameObserver const*> observers(std::vector<Frames const*> const& systems,
                                                     std::size_t which);

  std::vector<Observed> observed_;
};

/// Observables of observers of one kind, [R], one of each system.
std::vector<SampledObservable> joined_observables(std::vector<FrameObserver const*> const& systems);

}  // namespace bagnold
