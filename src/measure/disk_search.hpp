// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/neighbors/neighbor_search.hpp"
#include "src/engine/device_copy.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Frames are rare, so they are measured on one thread of the host, in the order of the disks.
using FrameSpace = Kokkos::Serial;

/// Search of all disks within d_ij + reach of a disk, [d_s]. The state's disks are in the box,
/// which is at least 2 (d_max + reach) wide.
inline NeighborSearch<FrameSpace> disk_search(State const& state, double reach) {
  NeighborSearch<FrameSpace> search;
  search.position = to_device<FrameSpace>("measure::position", vectors(state.position));
  search.species = to_device<FrameSpace>("measure::species", species_of(state.diameter));
  search.table = make_species_table(false);  // only the diameters are used
  search.box = {state.box_length, state.offset, state.strain_rate.value(), state.box_height()};
  search.grid = make_cell_grid(FrameSpace{}, search.position, search.box, big_diameter + reach);
  search.skin = reach;
  return search;
}

}  // namespace bagnold
