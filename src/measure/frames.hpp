// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "src/config/plan.hpp"
#include "src/engine/simulation.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Which observers are shown which configurations of one simulation.
///
/// An observer sees the first configuration at or after each multiple of its spacing at which the
/// engine can stop; where windows are longer than the spacing, multiples share a frame. That does
/// not depend on how the run is cut into calls, if each goes no further than next().
class Frames {
 public:
  /// plan: of the run, which tells the strain of a step.
  explicit Frames(Plan const& plan = {}) : plan_(plan) {}

  /// spacing: [steps], 1 at least. Frames before first_step are not shown.
  void add_observer(std::unique_ptr<FrameObserver> observer, std::int64_t spacing,
                    std::int64_t first_step = 0);

  /// The first step after `step` that an observer waits for.
  std::int64_t next(std::int64_t step) const;

  /// Shows the configuration to all that have waited for one since step `from`, which they have
  /// seen; -1: since before step 0.
  void show(Simulation const& simulation, std::int64_t from);

  /// To all observers, see FrameObserver.
  void know_contacts(std::shared_ptr<ContactRecord const> const& record);
  void begin();
  ObserverState save();
  void load(ObserverState const& numbers);
  void forget_before(std::int64_t step);
  std::vector<std::string> lost() const;
  void finish();
  void tidy();

  /// What the same observers found on the frames of several systems, [R], one at least.
  static FrameResults join(std::vector<Frames const*> const& systems);
  static std::vector<SampledObservable> observables(std::vector<Frames const*> const& systems);

 private:
  struct Observed {
    std::unique_ptr<FrameObserver> observer;
    std::int64_t spacing;
    std::int64_t first_step;

    bool waits(std::int64_t from, std::int64_t to) const;
  };
  Plan plan_;
  static std::vector<FrameObserver const*> observers(std::vector<Frames const*> const& systems,
                                                     std::size_t which);

  std::vector<Observed> observed_;
};

/// What observers of one kind measure, [R], of each system one.
std::vector<SampledObservable> joined_observables(std::vector<FrameObserver const*> const& systems);

}  // namespace bagnold
