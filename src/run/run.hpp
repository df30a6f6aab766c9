// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "src/config/scene.hpp"
#include "src/run/machine.hpp"
#include "src/run/monitor.hpp"

namespace bagnold {

struct RunOptions {
  Machine machine{};
  bool replace = false;            ///< the run that is in the folder
  bool allow_unstable = false;     ///< accept a time step beyond the scheme's stability
  std::optional<double> strain{};  ///< of resume(): make the run, or a cascade's last rate, as long
  RunMonitor* monitor = nullptr;   ///< may be null
};

/// Runs a scene, also a cascade, into a folder, which is made, with results, checkpoints and
/// pictures, as `bagnold run` does. If the folder holds a run of the same resolved scene, continues
/// it as resume() does; a finished one is left unchanged. Starts Kokkos if it does not run yet;
/// warnings go to stderr.
///
/// Throws InputError if the scene or the machine cannot be run, or the folder holds a run of
/// another scene; NumericalError if the physics fails, with the state in the folder; FileError.
RunEnd run(Scene scene, std::filesystem::path const& folder, RunOptions const& options = {});

/// Continues the run in a folder, bit for bit, from its newest checkpoint that verifies, as
/// `bagnold resume` does. A finished run is left unchanged, unless `options.strain` makes it longer
/// (make_longer.hpp). Of `options` only the strain, the machine and the monitor are used.
RunEnd resume(std::filesystem::path const& folder, RunOptions const& options = {});

}  // namespace bagnold
