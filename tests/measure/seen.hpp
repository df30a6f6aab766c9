// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "src/measure/frames.hpp"
#include "src/statistics/replicas.hpp"

namespace bagnold::test {

/// All that observers of one kind, of each system one, have found.
struct Seen : FrameResults {
  std::map<std::string, statistics::ReplicaEstimate, std::less<>> scalars;
};

inline Seen seen_by(std::vector<FrameObserver const*> const& systems) {
  Seen seen;
  systems.front()->report(systems, seen);
  for (auto const& [observable, frames] : joined_observables(systems))
    seen.scalars.emplace(observable.name, statistics::estimate(frames, 0, observable.value));
  return seen;
}

}  // namespace bagnold::test
