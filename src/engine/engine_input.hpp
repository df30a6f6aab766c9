// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/species.hpp"
#include "src/config/strain_rates.hpp"
#include "src/engine/drives/drive_setup.hpp"

namespace bagnold {

struct Scene;

/// Keys that choose the types of a scene's physics, and the constants of its law.
struct PhysicsInput {
  DampingInput damping;
  double force_exponent = 2;  ///< alpha
  std::string scheme;         ///< a name of kernels/physics/schemes
  std::string asked_scheme;   ///< integration.scheme, may be "auto"
};

PhysicsInput physics_input(Scene const& scene);

/// All that engines which step disks take from a scene. They do not see its keys, so a new key
/// compiles none of them anew.
struct EngineInput {
  std::string model;   ///< name of the law
  std::string engine;  ///< integration.engine
  PhysicsInput physics;
  bool rotates;           ///< the law
  double normal_damping;  ///< of a law that is linear in the velocity, [m/tau_e]
  double tangential_damping;
  SpeciesTable species;
  StrainRates rates;
  double time_step;  ///< dt, [tau_e]
  double skin;       ///< [d_s]
  bool contacts;     ///< measure.contacts
  std::optional<DriveSetup> drive = {};
};

/// initial_time: of the run, [tau_e], for the random numbers of its drive.
EngineInput engine_input(Scene const& scene, double initial_time = 0);

}  // namespace bagnold
