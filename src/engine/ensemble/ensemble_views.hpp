// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/schemes/scheme.hpp"
#include "kernels/physics/schemes/second_stage.hpp"
#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/device/sums/measure.hpp"
#include "src/engine/clock.hpp"

namespace bagnold {

/// A value for each disk of each system: a system's part lies in one piece on every backend.
template <class T, class Space>
using SystemTable = Kokkos::View<T**, Kokkos::LayoutRight, Space>;

/// One system's part of a table; it does not keep the table alive.
template <class T, class Space>
KOKKOS_FUNCTION Kokkos::View<T*, Space> part(SystemTable<T, Space> const& table,
                                             std::size_t system) {
  return Kokkos::View<T*, Space>(table.data() + system * table.extent(1), table.extent(1));
}

/// What a step keeps of one system's disks beside trial positions and motions: nothing, or with two
/// stages how many contacts each has. There the trial Views hold the next positions and what the
/// first stage changes.
template <Scheme, class Space>
struct StepViews {};

template <class Space>
struct StepViews<Scheme::two_stage_leapfrog, Space> {
  Kokkos::View<int*, Space> contacts;             ///< [N]
  Kokkos::View<SecondStage const*, Space> shares;  ///< [1]
};

/// The same of many systems.
template <Scheme Stepped, class Space>
struct StepTables {
  KOKKOS_FUNCTION StepViews<Stepped, Space> of(std::size_t) const { return {}; }
};

template <class Space>
struct StepTables<Scheme::two_stage_leapfrog, Space> {
  SystemTable<int, Space> contacts;
  Kokkos::View<SecondStage*, Space> shares;

  KOKKOS_FUNCTION StepViews<Scheme::two_stage_leapfrog, Space> of(std::size_t s) const {
    return {part(contacts, s), Kokkos::View<SecondStage const*, Space>(shares.data(), 1)};
  }
};

/// The Views of one system of an ensemble, as kernels for one system want them.
template <bool Rotates, class Space, Scheme Stepped>
struct SystemViews {
  template <class T>
  using Row = Kokkos::View<T*, Space>;

  Row<Vec2<Real>> position, trial_position, at_build;  ///< [N], [d_s]
  Row<Motion<Rotates>> motion, trial_motion;           ///< [N]
  Row<Species> species;                                ///< [N]
  NeighborRows<Space> neighbors;
  Row<std::uint32_t> cell_first, cell_members, cell_filled;
  Row<Sums<Rotates>> disk_sums, block_sums;  ///< [N], [ceil(N / measured_block)]
  Row<Sums<Rotates>> samples;                ///< those measured since the host took them
  StepViews<Stepped, Space> step;
};

/// What many systems of N disks consist of: Views with the system as the leading index.
template <bool Rotates, class Space, Scheme Stepped>
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
  Table<Sums<Rotates>> disk_sums, block_sums, samples;
  StepTables<Stepped, Space> step;

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
        block_sums("observables::block_sums", systems,
                   (disks + measured_block - 1) / measured_block),
        samples("observables::samples", systems, room_for_samples) {}

  /// Room for the cells of a grid of that many along an edge.
  void make_cells(std::size_t side) {
    auto const systems = position.extent(0);
    cell_first = Table<std::uint32_t>("neighbors::first", systems, side * side + 1);
    cell_filled = Table<std::uint32_t>("neighbors::filled", systems, side * side + 1);
  }

  /// Room for so many neighbours of a system's disks; lists that were there are lost.
  void make_entries(std::size_t most) {
    entries = {};  // free before asking for more
    entries = Table<Neighbor>(Kokkos::view_alloc(Kokkos::WithoutInitializing, "neighbors::entries"),
                              position.extent(0), most);
  }

  KOKKOS_FUNCTION SystemViews<Rotates, Space, Stepped> of(std::size_t s) const {
    return {part(position, s),
            part(trial_position, s),
            part(at_build, s),
            part(motion, s),
            part(trial_motion, s),
            part(species, s),
            {part(row, s), part(entries, s)},
            part(cell_first, s),
            part(cell_members, s),
            part(cell_filled, s),
            part(disk_sums, s),
            part(block_sums, s),
            part(samples, s),
            step.of(s)};
  }
};

}  // namespace bagnold
