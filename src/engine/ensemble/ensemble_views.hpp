// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/stepped_system.hpp"
#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/device/sums/add_up.hpp"
#include "kernels/device/system_table.hpp"
#include "src/engine/clock.hpp"

namespace bagnold {

/// Views of one system of an ensemble, for kernels written for one system.
template <bool Rotates, class Space, class Scheme>
struct SystemViews {
  template <class T>
  using Row = Kokkos::View<T*, Space>;

  DiskViews<Rotates, Space, Scheme> disks;
  Row<std::uint32_t> cell_first, cell_members, cell_filled;
  Row<Sums<Rotates>> disk_sums, group_sums;  ///< [N], [groups_of_sums(N)]
  Row<Sums<Rotates>> samples;                ///< those measured since the host took them
};

/// Arrays of many systems of N disks: Views with the system as the leading index.
template <bool Rotates, class Space, class Scheme>
struct EnsembleViews {
  template <class T>
  using Table = SystemTable<T, Space>;

  /// Samples that a launch can measure before the host has to take them.
  static constexpr int room_for_samples = 64;

  Table<Vec2<Real>> position, trial_position, at_build;
  Table<Motion<Rotates>> motion, trial_motion;
  Table<Species> species;
  Table<std::uint32_t> row;
  Table<Neighbor> entries;
  Table<std::uint32_t> cell_first, cell_members, cell_filled;
  Table<Sums<Rotates>> disk_sums, group_sums, samples;
  StepTables<Rotates, Scheme, Space> step;

  EnsembleViews() = default;
  EnsembleViews(std::size_t systems, std::size_t disks)
      : position("state::position", systems, disks),
        trial_position("dynamics::trial_position", systems, disks),
        at_build("neighbors::at_build", systems, disks),
        motion("state::motion", systems, disks),
        trial_motion("dynamics::trial_motion", systems, disks),
        species("state::species", systems, disks),
        row("neighbors::row", systems, disks + 1),
        cell_members("neighbors::members", systems, disks),
        disk_sums("observables::disk_sums", systems, disks),
        group_sums("observables::group_sums", systems,
                   static_cast<std::size_t>(groups_of_sums(static_cast<std::int64_t>(disks)))),
        samples("observables::samples", systems, room_for_samples) {}

  /// Allocates grids of up to `cells` cells.
  void make_cells(std::size_t cells) {
    auto const systems = position.extent(0);
    cell_first = Table<std::uint32_t>("neighbors::first", systems, cells + 1);
    cell_filled = Table<std::uint32_t>("neighbors::filled", systems, cells + 1);
  }

  /// Allocates lists of up to `most` neighbours of a system's disks; existing lists are lost.
  void make_entries(std::size_t most) {
    entries = {};  // free before asking for more
    entries = Table<Neighbor>(Kokkos::view_alloc(Kokkos::WithoutInitializing, "neighbors::entries"),
                              position.extent(0), most);
  }

  KOKKOS_FUNCTION SystemViews<Rotates, Space, Scheme> of(std::size_t s) const {
    return {{part(position, s),
             part(trial_position, s),
             part(at_build, s),
             part(motion, s),
             part(trial_motion, s),
             part(species, s),
             {part(row, s), part(entries, s)},
             step.of(s)},
            part(cell_first, s),
            part(cell_members, s),
            part(cell_filled, s),
            part(disk_sums, s),
            part(group_sums, s),
            part(samples, s)};
  }
};

}  // namespace bagnold
