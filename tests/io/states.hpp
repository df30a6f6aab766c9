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
  state.offset = 0.1;
  state.time = 1.0 / 3.0;
  state.strain_rate = 1e-4;
  return state;
}

/// A checkpoint with every field set.
inline Checkpoint some_checkpoint(std::size_t count, std::int64_t step) {
  auto const seed = static_cast<unsigned>(step);
  Checkpoint checkpoint;
  checkpoint.scene = "title = \"a test, \u03c6 = 0.82\"\n";
  checkpoint.state = some_state(count, seed);
  checkpoint.list_position = some_state(count, seed + 1).position;
  checkpoint.list_step = step - 7;
  checkpoint.step = step;
  checkpoint.initial_offset = 0.3;
  checkpoint.initial_time = 11.0;
  checkpoint.window_sums = {1.0, 2.0, 3.0, 4.0, 5.0, 1.0 / 7.0};
  checkpoint.columns = 3;
  checkpoint.window_weight = {10.0, 11.0};
  checkpoint.open_sums = {0.5, 0.25, 0.125};
  checkpoint.open_weight = 3.0;
  checkpoint.start_record = {{"iterations", 12.0}, {"overlap", 1e-9}};
  checkpoint.wall_seconds = 1.5;
  checkpoint.builds = 42;
  checkpoint.engine = {{"margin", 0.015}, {"prune_step", 117.0}};
  return checkpoint;
}

}  // namespace bagnold::io
