// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kernels/physics/drives/drive.hpp"
#include "kernels/physics/random.hpp"

namespace bagnold {

/// One-body force of a scene: its parameters and its random numbers. The time at which the run
/// began enters these, so that a run that continues another one with its seed has different ones.
struct DriveSetup {
  std::string kind;
  DriveInput input;
  RandomStream stream;
};

}  // namespace bagnold
