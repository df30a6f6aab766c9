// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace bagnold::bench {

/// A row of docs/performance.md: how long a system in its steady state takes for a strain.
struct Row {
  char const* state;     ///< folder with state.h5 and the scene.toml that made it
  double strain;         ///< timed, by engines that can leave out steps; others are cut short
  int threads = 1;       ///< of Kokkos, for one system
  int side_by_side = 1;  ///< threads with a replica each
};

/// Strains that take seconds on one core.
inline constexpr std::array rows{
    Row{"cd_rot82-1e-4-1024", 1.0},         Row{"cd_rot82-1e-4-65536", 0.02},
    Row{"cd_rot82-1e-4-65536", 0.02, 2},    Row{"cd_rot82-1e-4-1024x2", 0.5},  // two replicas
    Row{"cd_rot82-1e-4-1024x2", 0.5, 1, 2}, Row{"cd_rot82-1e-4-16384", 0.08},
    Row{"cd_rot82-1e-4-1048576", 0.0012},   Row{"cd_n-q50-1e-4-1024", 4.0},
    Row{"cd_n-q50-1e-5-1024", 4.0},         Row{"cd_n-q50-1e-6-1024", 3.0},
    Row{"cd_n-q50-1e-5-65536", 0.1},        Row{"cd_n-q50-1e-6-65536", 0.1},
    Row{"cd_n-q1-1e-5-1024", 1.0},          Row{"cd_rot76-1e-5-1024", 0.3},
};

/// Where the states lie, and how much of a row is run.
struct RowOptions {
  std::string states = "results/bench-states";
  double shorter = 1.0;  ///< strains are divided by this
  int threads = 1;       ///< that Kokkos was started with
};

/// Registers each row for each engine, as STATE/ENGINE, STATE/ENGINE/threads:T or
/// STATE/ENGINE/side_by_side:T. A row whose
/// state is missing is skipped with a message.
void register_rows(RowOptions const& options);

}  // namespace bagnold::bench
