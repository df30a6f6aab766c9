// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/config/errors.hpp"
#include "src/start/start.hpp"

/// Scenes that start from a state file, for the tests, and what is said of states that do not fit.
namespace bagnold {

/// Of 20 disks.
inline Scene scene_from_state(std::string const& model) {
  Scene scene;
  scene.disks.model = model;
  scene.disks.mass = "equal";
  scene.disks.count = 20;
  scene.disks.packing_fraction = 0.7;
  scene.disks.elasticity = 1;
  scene.shear.strain_rate = 3e-3;
  scene.shear.strain = 1;
  scene.start.kind = "state";
  scene.start.file = "/folder/state.h5";
  return scene;
}

/// The message with which states are refused as bad input; "accepted" if they are not.
inline std::string refusal(std::vector<State> const& states, Scene const& scene) {
  try {
    fit_to_scene(states, scene);
  } catch (InputError const& error) {
    return error.what();
  }
  return "accepted";
}

/// Whether a message holds all of these.
inline ::testing::AssertionResult names(std::string const& message,
                                        std::vector<std::string> const& parts) {
  for (auto const& part : parts)
    if (message.find(part) == std::string::npos)
      return ::testing::AssertionFailure() << "no '" << part << "' in: " << message;
  return ::testing::AssertionSuccess();
}

}  // namespace bagnold
