// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/config/scene.hpp"
#include "src/run/bias/judge.hpp"
#include "src/state/state.hpp"

namespace bagnold::bias {

/// A scheme and a step that were charted.
struct ChartedMethod {
  Scene scene;
  double time_step = 0;                   ///< [tau_e]
  double disk_steps = 0;                  ///< of a unit of strain
  double seconds = 0, seconds_error = 0;  ///< of CPU, a unit of strain
  bool failed = false;                    ///< a step of it did
  Judgement judgement;                    ///< beside the finest
};

struct Chart {
  Scene finest;
  std::size_t states = 0;
  double strain = 0;  ///< of a stretch
  std::vector<ChartedMethod> methods;
};

struct ChartRequest {
  double warm_up = 0.5;    ///< strain before the first state, by the usual method
  std::size_t states = 6;  ///< from which all methods step
  double apart = 0.1;      ///< strain between them

  /// Asked about twenty times a second, with what is done of all; false: stop.
  std::function<bool(double share, std::string const& what)> go_on;
};

/// Bias and cost of all methods that can step a steady scene, from states along one run of it: each
/// steps a stretch from each state, as pairs of a run do, and so do two stages at an eighth of
/// their rule. Kokkos runs. Returns fewer states than asked for if go_on stopped it.
Chart chart(Scene const& scene, State const& start, ChartRequest const& request);

}  // namespace bagnold::bias
