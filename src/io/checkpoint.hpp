// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/state/snapshot.hpp"

namespace bagnold::io {

/// All that one system needs to go on bit for bit, and what was measured on it.
struct SystemCheckpoint : Snapshot {
  std::vector<double> window_sums;    ///< finished windows, [n][columns]
  std::int64_t columns = 0;           ///< sums a window
  std::vector<double> window_weight;  ///< [n]
  std::vector<double> open_sums;      ///< of the window in progress
  double open_weight = 0.0;
  std::map<std::string, double> start_record;  ///< e.g. relaxation iterations, remaining overlap
  std::map<std::string, std::vector<double>> frames;  ///< what observers of frames know
};

/// All that a run needs to go on bit for bit. Form of the file: docs/files.md.
struct Checkpoint {
  std::string scene;          ///< resolved, TOML
  std::string simd;           ///< level of the engine, src/engine/levels; "" unknown
  double wall_seconds = 0.0;  ///< so far, [s]
  bool whole = true;  ///< no lookahead was cut short by the end of a run that may be made longer
  std::vector<SystemCheckpoint> systems;  ///< [R], one at least; each perhaps at a step of its own

  std::int64_t steps() const;  ///< done by all systems together
};

/// The sealed file in memory.
std::vector<std::byte> checkpoint_image(Checkpoint checkpoint);

/// Reads a checkpoint. InputError where the bytes are not one, whole and unchanged; `name` is for
/// messages.
Checkpoint parse_checkpoint(std::string const& name, std::vector<std::byte> image);

/// Writes `checkpoint.h5`; the one before is kept as `checkpoint.previous.h5`. The new one is
/// written to `checkpoint.h5.tmp`, brought to the disk and verified before any name changes, so
/// that after a kill at any instant at least one of the three verifies, if one did before. On
/// failure the older two are untouched, and FileError says what to do.
void write_checkpoint(std::filesystem::path const& folder, Checkpoint checkpoint);

/// The checkpoint with most steps, of all systems, that verifies, a finished temporary included;
/// nothing if none does. `remarks` (if not null) gets one line for each that was rejected.
/// FileError where none verifies and one of them cannot be read: it may be whole, and is not to be
/// run over.
std::optional<Checkpoint> newest_checkpoint(std::filesystem::path const& folder,
                                            std::vector<std::string>* remarks);

/// Removes all checkpoints, before a new run takes the folder; throws FileError.
void remove_checkpoints(std::filesystem::path const& folder);

}  // namespace bagnold::io
