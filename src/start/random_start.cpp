// SPDX-License-Identifier: BSD-3-Clause
#include <Random123/philox.h>
#include <fmt/format.h>

#include <Random123/uniform.hpp>

#include "kernels/physics/species.hpp"
#include "src/config/errors.hpp"
#include "src/start/relax_overlaps.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// What a random number is for, so that uses never share one.
enum Purpose : std::uint32_t { position_purpose = 1 };

/// A uniform point in the box, the same for a (seed, disk) everywhere.
std::array<double, 2> random_point(std::int64_t seed, std::uint64_t disk, State const& box) {
  using Philox = r123::Philox2x64;
  Philox const philox;
  Philox::key_type const key{{static_cast<std::uint64_t>(seed)}};
  Philox::ctr_type const counter{{disk, position_purpose}};
  Philox::ctr_type const random = philox(counter, key);
  return {r123::u01<double>(random[0]) * box.box_length,
          r123::u01<double>(random[1]) * box.box_height()};
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

  Relaxation const done = relax_overlaps(state, scene.start.overlap, scene.start.iterations,
                                         scene.integration.skin, go_on);
  started.record = {{"start_iterations", static_cast<double>(done.iterations)},
                    {"start_overlap", done.largest_overlap}};
  if (done.largest_overlap > 0.05)
    throw NumericalError(
        fmt::format("after {} iterations of relaxing the random start an overlap of {:.1f}% is "
                    "left (limit 5%); "
                    "lower disks.packing_fraction = {}, or raise start.iterations = {}",
                    done.iterations, 100 * done.largest_overlap, scene.disks.packing_fraction,
                    scene.start.iterations));

  state.velocity.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    state.velocity[i] = {scene.shear.strain_rate * state.position[i][1], 0.0};
  if (scene.rotates()) state.spin.assign(count, -scene.shear.strain_rate / 2);
  return started;
}

}  // namespace bagnold
