// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "src/run/bias/course.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold::bias {

/// The course of a run, which replicas on threads of their own share.
struct SharedCourse {
  std::mutex mutex;
  Course course;
  std::string backend;
  bool ended = false;  ///< no pair begins any more
};

/// Takes the pairs of one replica. A pair is a function of the state from which it begins, and of
/// nothing else: the run's own system is only read. With scheme = "auto" it may get another method,
/// and one stretch of a pair may be its own (Own).
class ReplicaPairs {
 public:
  /// shared: with the pairs of all replicas. left(step): called by the replica's thread at the step
  /// at which the method of the run is left, and what was before is left out.
  ReplicaPairs(SharedCourse& shared, std::size_t replica, std::function<void(std::int64_t)> left)
      : shared_(shared),
        replica_(replica),
        left_(std::move(left)),
        dropped_(shared.course.dropped()) {}

  /// First step after `step` at which the run stops for a pair.
  std::int64_t next(std::int64_t step) const;

  /// Steps of the run's method between evaluations: `usual`, or those of a stretch that is its own.
  std::int64_t every(std::int64_t usual) const;

  /// Takes a pair at the present step if one is due. Returns false if go_on did, or if other
  /// replicas have to come first; called again it goes on. A pair under way is in no checkpoint.
  /// windows: that are done.
  bool take(Simulation& run, statistics::Windows const& windows,
            std::function<bool()> const& go_on);

  /// True if the run may get another method where replicas have a pair.
  bool chooses() const { return shared_.course.chooses(); }

  /// True if a pair is due at this step.
  bool awaited(std::int64_t step) const;

  /// Numbers of the pairs so far, for a checkpoint.
  std::vector<double> save() const;

 private:
  bool is_due(std::int64_t step) const;
  void add_own(Simulation const& run, statistics::Windows const& windows);
  bool take_due(Simulation const& run, statistics::Windows const& windows,
                std::function<bool()> const& go_on);

  SharedCourse& shared_;
  std::size_t replica_;
  std::function<void(std::int64_t)> left_;
  std::int64_t dropped_;              ///< Course.dropped() as far as it was told
  std::optional<State> start_;        ///< of the pair under way
  std::optional<Averages> coarse_;    ///< its first stretch, once done
  std::unique_ptr<Stretch> stretch_;  ///< under way
};

}  // namespace bagnold::bias
