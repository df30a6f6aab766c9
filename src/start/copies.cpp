// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"
#include "src/config/strain_rates.hpp"

namespace bagnold {

namespace {

/// k_x and k_y with k_x k_y = number whose box has an aspect nearest to the one wanted.
Copies nearest(std::int64_t number, double box_aspect, double wanted) {
  Copies best{number, 1};
  double least = INFINITY;
  for (std::int64_t across = 1; across <= number; ++across) {
    if (number % across != 0) continue;
    Copies const tried{number / across, across};
    double const away = std::abs(std::log(tried.aspect(box_aspect) / wanted));
    if (away < least) {
      least = away;
      best = tried;
    }
  }
  return best;
}

}  // namespace

Copies copies_that_fit(std::string const& what, std::int64_t count, double box_aspect,
                       Scene const& scene) {
  auto const& disks = scene.disks;
  auto const number = disks.count / count;
  if (number * count != disks.count)
    throw InputError(
        fmt::format("{} holds {} disks, disks.count = {} (must be a multiple of them "
                    "for start.copies); set disks.count = {}",
                    what, count, disks.count, count * std::max<std::int64_t>(1, number)));
  auto const fitting = nearest(number, box_aspect, disks.box_aspect);
  double const made = fitting.aspect(box_aspect);
  if (!(std::abs(made - disks.box_aspect) <= 1e-9 * disks.box_aspect))
    throw InputError(fmt::format(
        "{0} has box_aspect = {1}, of which start.copies cannot make disks.box_aspect = {2} (must "
        "be {1} k_y / k_x with k_x k_y = {3}); set disks.box_aspect = {4}, k_x = {5} and k_y = {6}",
        what, box_aspect, disks.box_aspect, number, made, fitting.along, fitting.across));
  return fitting;
}

State copies(State const& state, Scene const& scene) {
  auto const fitting =
      copies_that_fit(scene.start.file + ":", std::ssize(state.position), state.box_aspect, scene);
  double const length = state.box_length, height = state.box_height();
  double const own_rate = state.strain_rate.value_or(first_rate(scene));
  double const rate = scene.start.rescale ? own_rate : first_rate(scene);
  State many = state;
  many.position.clear();
  many.velocity.clear();
  many.spin.clear();
  many.diameter.clear();
  many.box_length = static_cast<double>(fitting.along) * length;
  many.box_aspect = fitting.aspect(state.box_aspect);
  many.offset = std::fmod(static_cast<double>(fitting.across) * state.offset, many.box_length);
  for (std::int64_t row = 0; row < fitting.across; ++row)
    for (std::int64_t column = 0; column < fitting.along; ++column) {
      auto const up = static_cast<double>(row), on = static_cast<double>(column);
      for (std::size_t i = 0; i < state.count(); ++i) {
        double const x = state.position[i][0] + on * length + up * state.offset;
        many.position.push_back({x - many.box_length * std::floor(x / many.box_length),
                                 state.position[i][1] + up * height});
        many.velocity.push_back({state.velocity[i][0] + up * rate * height, state.velocity[i][1]});
      }
      many.spin.insert(many.spin.end(), state.spin.begin(), state.spin.end());
      many.diameter.insert(many.diameter.end(), state.diameter.begin(), state.diameter.end());
    }
  return many;
}

}  // namespace bagnold
