// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/engine/contacts/contact_record.hpp"
#include "src/engine/observables.hpp"
#include "src/state/state.hpp"
#include "src/statistics/tables.hpp"

namespace bagnold {

/// A configuration that observers are shown.
struct Frame {
  State const& state;     ///< disks in the box, with its strain rate
  std::int64_t step = 0;  ///< true one, at or after the one asked for
  double strain = 0.0;    ///< since step 0
};

/// What observers know, by name, as a checkpoint keeps it.
using ObserverState = std::map<std::string, std::vector<double>>;

/// What observers found, beside observables.
struct FrameResults {
  std::vector<statistics::Histogram> histograms;
  std::vector<statistics::Profile> profiles;
  std::vector<statistics::Samples> samples;
};

/// Measures something on a frame now and then.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;

  virtual void add(Frame const& frame) = 0;

  /// Adds all it needs to go on bit for bit. Called right before each checkpoint: what lies in
  /// files of its own must be on the disk when it returns.
  virtual void save(ObserverState& numbers) = 0;

  /// The inverse, before the first frame of a resumed run.
  virtual void load(ObserverState const& numbers) = 0;

  /// Forgets the frames before this strain, as if it had not been shown them: of a run that was
  /// made longer more is discarded. Those that cannot tell their frames apart forget all, and are
  /// asked only where no other frame was shown.
  virtual void forget_before(double /*strain*/) {}

  /// What of its files is no longer as it was saved, and what to do; empty: nothing. The run goes
  /// on.
  virtual std::string lost() const { return {}; }

  /// Adds what has been found so far. systems: observers of its kind, [R], of each system one,
  /// itself the first; errors are those of statistics/replicas.hpp.
  virtual void report(std::vector<FrameObserver const*> const& systems,
                      FrameResults& results) const = 0;

  /// Numbers that it measures, from a table whose rows are its frames.
  virtual std::vector<SampledObservable> observables() const { return {}; }

  /// The record of contacts of its system, if there is one, before the first frame.
  virtual void know_contacts(std::shared_ptr<ContactRecord const> const& /*record*/) {}

  /// A run begins that is not resumed; its last frame has been shown; all its results are written.
  virtual void begin() {}
  virtual void finish() {}
  virtual void tidy() {}
};

}  // namespace bagnold
