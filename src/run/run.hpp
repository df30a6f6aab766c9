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
  RunMonitor* monitor = nullptr;   ///< null: nobody
};

/// Runs a scene, a cascade too, into a folder, which is made: results, checkpoints, pictures and
/// all, as `bagnold run` does. Where the folder holds a run of the same resolved scene, goes on
/// with it as resume() does; a finished one is left as it is. Kokkos is started where it does not
/// run yet, and stays as it was found otherwise; warnings go to stderr.
///
/// Throws InputError where the scene or the machine is not fit to run, or the folder holds a run of
/// another scene; NumericalError where the physics fails, its state in the folder; FileError.
RunEnd run(Scene scene, std::filesystem::path const& folder, RunOptions const& options = {});

/// Goes on with the run in a folder, bit for bit, from its newest checkpoint that verifies, as
/// `bagnold resume` does; nothing is left to do in a finished one, unless `options.strain` makes it
/// longer (make_longer.hpp). Of `options` that, the machine and the monitor count.
RunEnd resume(std::filesystem::path const& folder, RunOptions const& options = {});

}  // namespace bagnold
