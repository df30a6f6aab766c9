// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/physics/species.hpp"
#include "src/config/errors.hpp"
#include "src/config/strain_rates.hpp"
#include "src/start/copies.hpp"
#include "src/start/mean_motion.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

void refuse_disagreement(State const& state, Scene const& scene) {
  auto const refuse = [&](std::string const& what) {
    throw InputError(fmt::format("{}: {}", scene.start.file, what));
  };
  std::size_t small = 0;
  for (std::size_t i = 0; i < state.count(); ++i) {
    double const d = state.diameter[i];
    bool const is_small = std::abs(d - small_diameter) < 1e-9;
    if (!is_small && !(std::abs(d - big_diameter) < 1e-9))
      refuse(fmt::format("/state/diameter[{}] = {} (must be {} or {} d_s)", i, d, small_diameter,
                         big_diameter));
    small += is_small;
  }
  if (2 * small != state.count())
    refuse(
        fmt::format("/state/diameter: {} of {} disks are small (must be half; no disks.count fits)",
                    small, state.count()));
  if (state.count() != static_cast<std::size_t>(scene.disks.count))
    refuse(fmt::format("holds {0} disks, disks.count = {1} (must agree); set disks.count = {0}{2}",
                       state.count(), scene.disks.count,
                       scene.disks.count % std::ssize(state.position) == 0
                           ? ", or start.copies = true for copies of it side by side"
                           : ""));
  double const length = scene.box_length(), aspect = scene.disks.box_aspect;
  if (!(std::abs(state.box_aspect - aspect) <= 1e-9 * aspect))
    refuse(
        fmt::format("box_aspect = {}, disks.box_aspect = {} (must agree to 1e-9); set "
                    "disks.box_aspect = {}",
                    state.box_aspect, aspect, state.box_aspect));
  bool const keeps_box = scene.shear.changes_box();  // which changes it anyhow
  if (!keeps_box && !(std::abs(state.box_length - length) <= 1e-9 * length))
    refuse(
        fmt::format("box_length = {} but disks.count = {} and disks.packing_fraction = {} give {} "
                    "(must agree to 1e-9); set disks.packing_fraction = {}{}",
                    state.box_length, scene.disks.count, scene.disks.packing_fraction, length,
                    scene.disks.packing_fraction * std::pow(length / state.box_length, 2),
                    scene.disks.replicas > 1 ? ", if all of its states have that box" : ""));
}

void refuse_other_number(std::vector<State> const& states, Scene const& scene) {
  auto const replicas = static_cast<std::size_t>(scene.disks.replicas);
  auto const refuse = [&](std::string const& what) {
    throw InputError(fmt::format("{}: {}", scene.start.file, what));
  };
  if (states.size() != replicas)
    refuse(fmt::format(
        "holds {} state{}, disks.replicas = {} (each replica needs a state of its own, and each "
        "state a replica); set disks.replicas = {}{}",
        states.size(), states.size() == 1 ? "" : "s", replicas, states.size(),
        replicas == 1 ? "" : ", or give a state file with as many"));
}

/// True if two states, without the motion of all disks together, differ by rounding at most.
bool are_alike(State const& one, State const& other, double strain_rate) {
  if (one.position != other.position) return false;
  double const rounding = 1e-9 * strain_rate * small_diameter;
  return std::ranges::equal(one.velocity, other.velocity, [&](auto const& v, auto const& w) {
    return std::abs(v[0] - w[0]) <= rounding && std::abs(v[1] - w[1]) <= rounding;
  });
}

void refuse_alike(std::vector<StartedState> const& started, Scene const& scene) {
  for (std::size_t a = 0; a < started.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (are_alike(started[a].state, started[b].state, typical_rate(scene)))
        throw InputError(fmt::format(
            "{}: states {} and {} (from 0) are the same (must differ by more than the motion of "
            "all disks together, or their replicas run alike); make one of them anew, with "
            "another seed",
            scene.start.file, b, a));
}

/// Adds mean flow; motions keep their excess over it.
void change_flow(State& state, double rise) {
  for (std::size_t i = 0; i < state.count(); ++i)
    state.velocity[i][0] += rise * state.position[i][1];
  for (auto& spin : state.spin) spin -= rise / 2;
}

StartedState fit_one(State state, Scene const& scene) {
  StartedState started;
  if (scene.start.copies) {
    Scene one = scene;
    one.disks.count = std::ssize(state.position);
    one.disks.box_aspect = state.box_aspect;
    refuse_disagreement(state, one);
    state = copies(state, scene);
    started.record["start_copies"] =
        static_cast<double>(scene.disks.count) / static_cast<double>(one.disks.count);
  } else {
    refuse_disagreement(state, scene);
  }
  double const rate = first_rate(scene), made_at = state.strain_rate.value_or(rate);
  if (!scene.rotates()) {
    state.spin.clear();
  } else if (state.spin.empty()) {
    state.spin.assign(state.count(), -made_at / 2);
    started.record["start_spins_assumed"] = 1;
  }
  if (scene.start.rescale && scene.shear.by_pieces()) {
    change_flow(state, rate - made_at);
  } else if (scene.start.rescale && made_at != rate) {
    if (!(made_at > 0))
      throw InputError(
          fmt::format("{}: strain_rate = {} (must be positive to scale velocities); "
                      "set start.rescale = false",
                      scene.start.file, made_at));
    double const ratio = rate / made_at;
    for (auto& v : state.velocity) v = {v[0] * ratio, v[1] * ratio};
    for (auto& spin : state.spin) spin *= ratio;
    started.record["start_velocity_scale"] = ratio;
  }
  state.strain_rate = rate;
  if (!scene.driven())  // else the fluid changes it
    started.mean_motion = take_off_mean_motion(state, scene);
  started.state = std::move(state);
  return started;
}

/// Records the mean motion subtracted from each state if any state had one, so that all records
/// have the same names.
void record_mean_motions(std::vector<StartedState>& started) {
  if (std::ranges::none_of(started, [](auto const& one) { return one.mean_motion.has_value(); }))
    return;
  for (auto& one : started) {
    auto const off = one.mean_motion.value_or(MeanMotion{});
    one.record[start_mean_velocity_x] = off.velocity[0];
    one.record[start_mean_velocity_y] = off.velocity[1];
    one.record[start_mean_motion_share] = off.share;
  }
}

}  // namespace

std::vector<StartedState> fit_to_scene(std::vector<State> states, Scene const& scene) {
  refuse_other_number(states, scene);
  std::vector<StartedState> started;
  for (State& state : states) started.push_back(fit_one(std::move(state), scene));
  refuse_alike(started, scene);
  record_mean_motions(started);
  return started;
}

}  // namespace bagnold
