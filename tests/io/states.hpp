// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>

#include "src/io/checkpoint.hpp"

namespace bagnold::io {

/// A state with every field set, different for each seed; no physics.
inline State some_state(std::size_t count, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-10.0, 10.0);
  State state;
  for (std::size_t disk = 0; disk < count; ++disk) {
    state.position.push_back({number(random), number(random)});
    state.velocity.push_back({number(random), number(random)});
    state.spin.push_back(number(random));
    state.diameter.push_back(disk % 2 == 0 ? 1.0 : 1.4);
  }
  state.box_length = 12.25;
  state.box_aspect = 1.0 / 3.0;
  state.offset = 0.1;
  state.time = 1.0 / 3.0;
  state.strain_rate = 1e-4;
  return state;
}

/// A system with every field set.
inline SystemCheckpoint some_system(std::size_t count, std::int64_t step) {
  auto const seed = static_cast<unsigned>(step);
  SystemCheckpoint system;
  system.state = some_state(count, seed);
  system.list_position = some_state(count, seed + 1).position;
  system.list_step = step - 7;
  system.step = step;
  system.initial_offset = 0.3;
  system.initial_time = 11.0;
  system.window_sums = {1.0, 2.0, 3.0, 4.0, 5.0, 1.0 / 7.0};
  system.columns = 3;
  system.window_weight = {10.0, 11.0};
  system.open_sums = {0.5, 0.25, 0.125};
  system.open_weight = 3.0;
  system.start_record = {{"iterations", 12.0}, {"overlap", 1e-9}};
  system.frames = {{"profiles", {0.1 * static_cast<double>(step), -0.0, 5e-324}}, {"fields", {}}};
  system.list_builds = 42;
  system.memory = {{"margin", 0.015}, {"prune_step", 117.0}};
  system.counters = {{"prunings", 3.0}};
  return system;
}

/// A checkpoint of one system with every field set.
inline Checkpoint some_checkpoint(std::size_t count, std::int64_t step) {
  Checkpoint checkpoint;
  checkpoint.scene = "title = \"a test, \u03c6 = 0.82\"\n";
  checkpoint.wall_seconds = 1.5;
  checkpoint.systems = {some_system(count, step)};
  return checkpoint;
}

}  // namespace bagnold::io
