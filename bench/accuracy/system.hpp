// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>

#include "bench/accuracy/near_pairs.hpp"
#include "bench/accuracy/sample.hpp"
#include "src/config/scene.hpp"

namespace bagnold::accuracy {

/// How a scene is stepped.
struct Method {
  std::string scheme = "modified-velocity-verlet";
  double time_step = 0.05;  ///< [tau_e]
  std::string precision = "double";
  Arrangement arrangement{};
  bool elastic = true;  ///< false: damping alone, for questions of stability
};

/// One system under one scheme, whatever its law and precision.
class System {
 public:
  virtual ~System() = default;
  virtual void step(Sample* sample) = 0;
  virtual State state() const = 0;
  virtual Counts counts() const = 0;
  virtual void place(State const& state) = 0;  ///< puts the disks back, keeps their motion
};

/// The names of all schemes.
std::span<std::string const> scheme_names();

/// The model, the rate and the constants come from the scene. `synchronous`: the state's velocities
/// are those of its time; a scheme that keeps them half a step behind is then given them there, to
/// first order. Throws InputError for a word it does not know.
std::unique_ptr<System> make_system(Scene const& scene, State const& state, Method const& method,
                                    bool synchronous = false);

}  // namespace bagnold::accuracy
