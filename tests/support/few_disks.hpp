// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "src/config/scene.hpp"
#include "src/state/state.hpp"

/// Disks in contact without force to speak of, which damping alone moves.
namespace bagnold {

/// Two disks that slide along each other in a box of 10.
struct SlidingPair {
  static constexpr double slide = 1e-3, overlap = 1e-6, time_step = 0.4;

  explicit SlidingPair(Scene const& scene)
      : rotates(scene.rotates()),
        tangential(scene.disks.model == "CD_nt" ? scene.disks.damping_tangential : 1.0) {}

  bool rotates;
  double tangential;  ///< damping constant

  /// The scene of a pair of mass 1 each.
  static Scene scene(Scene of) {
    of.shear.strain_rate = 0.0;
    of.disks.mass = "equal";
    of.integration.skin = 0.5;
    of.integration.time_step = time_step;
    return of;
  }

  State start() const {
    State state;
    state.box_length = 10.0;
    state.position = {{4.0, 5.0}, {5.0 - overlap, 5.0}};
    state.velocity = {{0.0, slide / 2}, {0.0, -slide / 2}};
    if (rotates) state.spin = {0.0, 0.0};
    state.diameter = {1.0, 1.0};
    return state;
  }

  /// Tangential velocity at the contact.
  double slip(State const& after) const {
    double const sliding = after.velocity[0][1] - after.velocity[1][1];
    return rotates ? sliding + 0.5 * (after.spin[0] + after.spin[1]) : sliding;
  }

  /// Its rate of decay times a step: d/dt v_t = -k_t (2/m) v_t, with spins
  /// -k_t (2/m + 2 (d/2)^2/I) v_t = -k_t (6/m) v_t.
  double decay() const { return tangential * time_step * (rotates ? 6.0 : 2.0); }
};

/// Five disks, a triangle and a chain from it, in a box of 12.
inline State crowd(Scene const& scene) {
  double const overlap = 1e-9, side = 1 - overlap, high = 1.2 - overlap;
  State state;
  state.box_length = 12.0;
  state.position = {{4, 4}, {4 + side, 4}, {4 + side / 2, 4 + side * std::sqrt(0.75)}};
  state.position.push_back({state.position[2][0], state.position[2][1] + high});
  state.position.push_back({state.position[2][0] + high, state.position[3][1]});
  state.diameter = {1.0, 1.0, 1.0, 1.4, 1.0};
  state.velocity = {{1e-3, 2e-3}, {-2e-3, 1e-3}, {3e-3, -1e-3}, {-1e-3, -2e-3}, {-2e-3, 2e-3}};
  if (scene.rotates()) state.spin = {1e-3, -3e-3, 2e-3, 4e-3, -1e-3};
  return state;
}

}  // namespace bagnold
