// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"

namespace bagnold {

Copies copies_that_fit(std::string const& what, std::int64_t count, double box_aspect,
                       Scene const& scene) {
  auto const number = scene.disks.count / count;
  if (number * count != scene.disks.count)
    throw InputError(
        fmt::format("{0} holds {1} disks, disks.count = {2} (must be a multiple of them "
                    "for start.copies); set disks.count = {3}",
                    what, count, scene.disks.count, count * std::max<std::int64_t>(1, number)));
  double const taller = scene.disks.box_aspect / box_aspect;
  auto const across = std::llround(std::sqrt(static_cast<double>(number) * taller));
  std::int64_t const along = across > 0 ? number / across : 0;
  double const made = along > 0 ? static_cast<double>(across) / static_cast<double>(along) : 0;
  if (along * across != number || !(std::abs(made - taller) <= 1e-9 * taller))
    throw InputError(fmt::format(
        "{0} has box_aspect = {1}, of which start.copies cannot make disks.box_aspect = {2} (must "
        "be {1} k_y / k_x with k_x k_y = {3}); set disks.box_aspect = {4} for all beside each "
        "other",
        what, box_aspect, scene.disks.box_aspect, number,
        box_aspect / static_cast<double>(number)));
  return {along, across};
}

State copies(State const& state, Scene const& scene) {
  auto const [along, across] =
      copies_that_fit(scene.start.file + ":", std::ssize(state.position), state.box_aspect, scene);
  double const length = state.box_length, height = state.box_height();
  double const faster = state.strain_rate.value_or(scene.shear.strain_rate) * height;
  State many = state;
  many.position.clear();
  many.velocity.clear();
  many.spin.clear();
  many.diameter.clear();
  many.box_length = static_cast<double>(along) * length;
  many.box_aspect = state.box_aspect * static_cast<double>(across) / static_cast<double>(along);
  many.offset = std::fmod(static_cast<double>(across) * state.offset, many.box_length);
  for (std::int64_t up = 0; up < across; ++up)
    for (std::int64_t on = 0; on < along; ++on) {
      auto const m = static_cast<double>(up), k = static_cast<double>(on);
      for (std::size_t i = 0; i < state.count(); ++i) {
        double const x = state.position[i][0] + k * length + m * state.offset;
        many.position.push_back({x - many.box_length * std::floor(x / many.box_length),
                                 state.position[i][1] + m * height});
        many.velocity.push_back({state.velocity[i][0] + m * faster, state.velocity[i][1]});
      }
      many.spin.insert(many.spin.end(), state.spin.begin(), state.spin.end());
      many.diameter.insert(many.diameter.end(), state.diameter.begin(), state.diameter.end());
    }
  return many;
}

}  // namespace bagnold
