// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/config/scene.hpp"
#include "src/engine/drives/drive_setup.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// A kind of processor that the engine on blocks is compiled for.
struct Level {
  std::string_view name;  ///< "baseline", "avx2", "avx512"
  bool here;              ///< this processor has what it needs

  /// See src/engine/blocks/make_block_engine.hpp.
  std::unique_ptr<Simulation> (*make)(Scene const&, Snapshot&, std::optional<DriveSetup> const&,
                                      std::string const& backend);
};

/// Those of this build, the most able first. One is what everything else is compiled for.
std::vector<Level> const& levels();

/// That which runs: the first of the list that this processor has, or the one that BAGNOLD_SIMD in
/// the environment names. Throws InputError where that is not in this build, or not for this
/// processor.
Level const& chosen_level();

/// That of a scene. Laws and drives that a program registered are compiled as everything else.
Level const& level_of(Scene const& scene);

}  // namespace bagnold
