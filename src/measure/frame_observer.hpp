// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/engine/contacts/contact_record.hpp"
#include "src/measure/observable.hpp"
#include "src/state/state.hpp"
#include "src/statistics/tables.hpp"

namespace bagnold {

/// A configuration that is shown to observers.
struct Frame {
  State const& state;     ///< disks in the box, with its strain rate
  std::int64_t step = 0;  ///< true one, at or after the one asked for
  double strain = 0.0;    ///< since step 0
};

/// Numbers of observers by name, as a checkpoint keeps them.
using ObserverState = std::map<std::string, std::vector<double>>;

/// Results of observers besides observables.
struct FrameResults {
  std::vector<statistics::Histogram> histograms;
  std::vector<statistics::Profile> profiles;
  std::vector<statistics::Samples> samples;
};

/// Measures a quantity on frames.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;

  virtual void add(Frame const& frame) = 0;

  /// Adds all numbers that a bit-for-bit restart needs. Called right before each checkpoint: data
  /// in files of its own must be on the disk when it returns.
  virtual void save(ObserverState& numbers) = 0;

  /// Inverse of save(), before the first frame of a resumed run.
  virtual void load(ObserverState const& numbers) = 0;

  /// Forgets the frames before this strain: more is discarded of a run that was made longer, or
  /// that left its method.
  /// Observers that cannot separate their frames forget all, and are called only if no later frame
  /// was shown.
  virtual void forget_before(double /*strain*/) {}

  /// Whether it adds up its frames, and so forgets all of them.
  virtual bool adds_up() const { return false; }

  /// Message on files of the observer that are no longer as they were saved, and what to do; empty
  /// if there are none. The run continues.
  virtual std::string lost() const { return {}; }

  /// Adds the results so far. systems: observers of its kind, [R], one of each system, itself the
  /// first; errors are those of statistics/replicas.hpp.
  virtual void report(std::vector<FrameObserver const*> const& systems,
                      FrameResults& results) const = 0;

  /// Observables that it measures, from a table whose rows are its frames.
  virtual std::vector<SampledObservable> observables() const { return {}; }

  /// Passes the record of contacts of its system, if there is one, before the first frame.
  virtual void know_contacts(std::shared_ptr<ContactRecord const> const& /*record*/) {}

  /// Called when a run begins that is not resumed; after its last frame; and after all its results
  /// are written.
  virtual void begin() {}
  virtual void finish() {}
  virtual void tidy() {}
};

}  // namespace bagnold
