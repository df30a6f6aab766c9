// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kernels/physics/drives/drive.hpp"
#include "kernels/physics/random.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// The one-body force of a scene: what it is made of, and its random numbers.
struct DriveSetup {
  std::string kind;
  DriveInput input;
  RandomStream stream;
};

/// Nothing where no drive acts. initial_time: of the run, [tau_e], so that a run that goes on from
/// another one with its seed has numbers of its own.
std::optional<DriveSetup> drive_setup(Scene const& scene, double initial_time);

}  // namespace bagnold
