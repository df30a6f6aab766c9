// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/scene.hpp"
#include "src/simulation/simulation.hpp"
#include "src/start/start.hpp"

namespace bagnold::bench {

/// A dense scene at rate 1e-4 with the papers' mass rule for its law.
inline Scene scene_of(std::string const& law, std::int64_t count) {
  Scene scene;
  scene.disks = {law, count, 0.82, 1.0, law == "CD_n" ? "area" : "equal"};
  scene.start.iterations = 300;
  scene.shear.strain_rate = 1e-4;
  scene.shear.strain = 1.0;
  scene.integration.time_step = 0.05;
  return scene;
}

/// A random start of it, overlaps relaxed only roughly: contacts abound, as in a Newtonian state.
inline Snapshot start_of(Scene const& scene) {
  Snapshot snapshot;
  snapshot.state = random_start(scene).state;
  return snapshot;
}

}  // namespace bagnold::bench
