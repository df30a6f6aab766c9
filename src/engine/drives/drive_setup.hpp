// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kernels/physics/drives/drive.hpp"
#include "kernels/physics/random.hpp"

namespace bagnold {

struct Scene;

/// One-body force of a scene: its parameters and its random numbers.
struct DriveSetup {
  std::string kind;
  DriveInput input;
  RandomStream stream;
};

/// Setup of the drive; nothing if there is no drive. initial_time: of the run, [tau_e]. It enters
/// the random numbers, so that a run that continues another one with its seed has different ones.
std::optional<DriveSetup> drive_setup(Scene const& scene, double initial_time);

}  // namespace bagnold
