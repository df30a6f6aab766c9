// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string_view>

#include "bench/accuracy/sample.hpp"

namespace bagnold::accuracy {

/// A time step. step() brings position and motion of the world on by dt and calls
/// world.finish_step(); where a sample is asked for it adds what it exerts in this step: so means
/// over steps are those of the forces that acted.
template <class S, class World>
concept Scheme = requires(S scheme, World& world, Sample* sample) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::staggered } -> std::convertible_to<bool>;  // velocities are those of half a step before
  scheme.step(world, sample);
};

}  // namespace bagnold::accuracy
