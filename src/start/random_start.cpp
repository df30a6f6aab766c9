// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/species.hpp"
#include "src/start/even_out.hpp"
#include "src/start/random_pair.hpp"
#include "src/start/relax_overlaps.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// A uniform point in the box, the same for a (seed, disk) everywhere.
std::array<double, 2> random_point(std::int64_t seed, std::uint64_t disk, State const& box) {
  auto const [x, y] = random_pair(seed, disk, Purpose::position);
  return {x * box.box_length, y * box.box_height()};
}

}  // namespace

StartedState random_start(Scene const& scene, std::function<bool()> const& go_on) {
  auto const count = static_cast<std::size_t>(scene.disks.count);
  StartedState started;
  State& state = started.state;
  state.box_length = scene.box_length();
  state.box_aspect = scene.disks.box_aspect;
  state.strain_rate = scene.shear.strain_rate;
  state.position.resize(count);
  state.diameter.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    state.position[i] = random_point(scene.disks.seed, i, state);
    state.diameter[i] = i < count / 2 ? small_diameter : big_diameter;
  }

  if (is_large(state) && scene.start.iterations > 0) even_out(state);
  relax_start(state, scene, "the random start", started.record, go_on);

  state.velocity.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    state.velocity[i] = {scene.shear.strain_rate * state.position[i][1], 0.0};
  if (scene.rotates()) state.spin.assign(count, -scene.shear.strain_rate / 2);
  return started;
}

}  // namespace bagnold
