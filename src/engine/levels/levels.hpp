// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "src/engine/engine_input.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// A kind of processor that the engine on blocks is compiled for.
struct Level {
  std::string_view name;  ///< "baseline", "avx2", "avx512"
  bool here;              ///< this processor has what it needs

  /// See src/engine/blocks/make_block_engine.hpp.
  std::unique_ptr<Simulation> (*make)(EngineInput const&, Snapshot&, std::string const& backend);
};

/// Levels of this build, the most capable first. One of them is the level of all other code.
std::vector<Level> const& levels();

/// Level that runs: the first of the list that this processor supports, or the one that
/// BAGNOLD_SIMD in the environment names. Throws InputError if that is not in this build, or not
/// supported by this processor.
Level const& chosen_level();

/// Level that runs a scene. Laws and drives that a program registers have the level of all other
/// code.
Level const& level_of(std::string_view law, std::string_view drive);

}  // namespace bagnold
